"""What a quick look at names and texts says of values that facts may hold."""

from __future__ import annotations

import pytest

from rospkg_cli.files import PackageFiles
from rospkg_cli.package.facts_on_demand import facts_on_demand
from rospkg_cli.package.package import Package
from rospkg_cli.package.package_facts import PackageFacts
from rospkg_cli.package.quick_look import QuickLook
from rospkg_cli.package.workspace import Workspace
from rospkg_cli.ros.distros import Targets
from rospkg_cli.tree import MemoryTree, TreeEntry

MANIFEST = "<package format='3'><name>{}</name><export><build_type>ament_python</build_type></export></package>"
SETUP = "from setuptools import setup\nsetup(name='{0}', packages=['{0}'], py_modules=['lone'])\n"
FILES = {
    "package.xml": MANIFEST.format("my_pkg"),
    "setup.py": (
        "import copy\nfrom mine import made\n"
        "setup(package_dir={'renamed': 'src/other'}, tests_require=['pytest'], extras_require={'test': ['mock']})"
    ),
    "my_pkg/__init__.py": "",
    "src/other/__init__.py": "",
    "lib/fast.cpython-312.so": "",
    "include/my_pkg/a.hpp": "",
    "launch/all.launch.py": "Node(package='driver', executable='run')",
    "docs/words.txt": "unheard",
    "cmake/python.cmake": "pybind11_add_module(_core a.cpp)",
    "cmake/plain.cmake": "add_library(plain a.cpp)",
    "CMakeLists.txt": "PLUGINLIB_EXPORT_plugin_description_file(base plugins.xml)",
    "plugins.xml": "<library path='arm'><class type='arm::Planner' base_class_type='base::Planner'/></library>",
}


@pytest.mark.parametrize(
    "field, value, is_worth_it",
    [
        ("modules", "my_pkg", True), ("modules", "my_pkg_py", True), ("modules", "other.deep", True),
        ("modules", "fast", True), ("modules", "renamed", True), ("modules", "rename", False),
        ("modules", "_core", True), ("modules", "plain", False), ("modules", "unheard", False),
        ("modules", "src", True), ("modules", "docs", False), ("modules", "all", True),
        ("header_files", "my_pkg/a.hpp", True), ("header_files", "my_pkg/b.hpp", False),
        ("started_nodes", "driver", True), ("started_nodes", "unheard", False),
        ("handed_yaml", "driver", True), ("handed_yaml", "unheard", False),
        ("modules", "copy", False), ("modules", "mine", False), ("modules", "pytest", False),
        ("modules", "mock", False), ("plugins", "Planner", True), ("plugins", "Plan", True),
        ("plugins", "unheard", False), ("plugins", "unheard<int>", True), ("executables", "unheard", True),
    ],
)  # fmt: skip
def test_what_may_be_there(field: str, value: str, is_worth_it: bool) -> None:
    look = QuickLook(PackageFiles(MemoryTree.of(FILES)), "my_pkg")
    assert look.may_have(field, (value,)) is is_worth_it


@pytest.mark.parametrize(
    "files, is_worth_it",
    [
        ({"CMakeLists.txt": "project(a)"}, False),
        ({"CMakeLists.txt": "pluginlib_export_plugin_description_file(base ${file})"}, True),
        ({"cmake/more.cmake": "pluginlib_export_plugin_description_file(base a.plugin)"}, True),
        ({"package.xml": "<package><export><base plugin='${prefix}/a.plugin'/></export></package>"}, True),
        ({"package.xml": "<package><export><base plugin='${prefix}/a.xml'/></export></package>"}, False),
    ],
)
def test_descriptions_that_a_quick_look_does_not_find_may_be_there(files: dict[str, str], is_worth_it: bool) -> None:
    assert QuickLook(PackageFiles(MemoryTree.of(files)), "a").may_have("plugins", ("Planner",)) is is_worth_it


def waiting(name: str) -> PackageFacts:
    files = {
        "package.xml": MANIFEST.format(name),
        "setup.py": SETUP.format(name),
        f"{name}/__init__.py": "",
        "lone.py": "",
    }
    return facts_on_demand(Package(PackageFiles(MemoryTree.of(files))), Targets(), name, name)


def test_packages_on_demand_answer_as_others_do() -> None:
    ready = PackageFacts("b", "b", modules=frozenset({"b", "b.c", "lone"}))
    workspace = Workspace((waiting("a"), ready, waiting("c")))
    assert [facts.name for facts in workspace.having("modules", "lone")] == ["a", "b", "c"]
    assert [facts.name for facts in workspace.having("modules", "c")] == ["c"]
    assert [workspace.installing(name) for name in ("a", "b", "c", "d")] == ["a", "b", "c", ""]
    assert workspace.having("modules", "d") == ()


def test_nothing_is_collected_that_is_not_worth_it() -> None:
    facts = waiting("arm")
    assert Workspace((facts,)).having("modules", "unheard") == ()
    with pytest.raises(AttributeError):
        object.__getattribute__(facts, "modules")


@pytest.mark.parametrize("data", [b"x\n", b"\xff\xfe" + "a word\n".encode("utf-16-le"), b"\xfe\xff\0x"])
def test_a_word_is_found_without_its_text(data: bytes) -> None:
    files = PackageFiles(MemoryTree.of({"a.cpp": data, "b.cpp": b"a \xff word", "docs": TreeEntry("other", b"")}))
    assert files.holds("a.cpp", b"word") is (b"w" in data)
    assert files.holds("b.cpp", b"word")
    assert not files.holds("docs", b"word")
    assert not files.holds("nothing.cpp", b"word")

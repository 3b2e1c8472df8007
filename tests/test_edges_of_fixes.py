"""What decides a fix, at its edge: how the file is written, what stands beside, and what may be told from it."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import pytest
from reading import one

from rospkg_cli import disk_trace
from rospkg_cli.checks.depends.header_inclusions import Inclusions
from rospkg_cli.checks.params.rcl_validation import name_problem
from rospkg_cli.checks.setup.missing_modules import MissingModules
from rospkg_cli.edits.entry_points import separate_with_commas
from rospkg_cli.engine.fixing.apply import apply_fixes
from rospkg_cli.engine.run import process_pool
from rospkg_cli.engine.run.scope import Scope
from rospkg_cli.example import BACKDROPS, CMAKE, manifest, scripts, setup_py
from rospkg_cli.package.setup.setup_py import SetupPy
from rospkg_cli.ros.distros import Targets
from rospkg_cli.rules.cmake import cmk005_removed_command as cmk005
from rospkg_cli.rules.plugins import plg005_wrong_plugin_base as plg005
from rospkg_cli.source import Span
from rospkg_cli.testing import lint_files
from rospkg_cli.tree import MemoryTree

BASE = {path: text for path, text in BACKDROPS["ament_python"].items() if text is not None}
NODE = "import rclpy\n\n\ndef main():\n    rclpy.init()\n"


def mended(files: dict[str, str], code: str, path: str) -> str:
    """Return a file after all fixes of a rule, unsafe ones too."""
    fixes = [finding.fix for finding in lint_files(files, [code]).findings if finding.fix]
    changes, _ = apply_fixes(MemoryTree.of(files), fixes)
    entry = changes.get(path)
    return entry.text.text if entry else files[path]


@pytest.mark.parametrize("written", ["AMENT_TARGET_DEPENDENCIES", "Ament_Target_Dependencies"])
def test_a_command_in_capitals_is_replaced_by_one_in_capitals(written: str) -> None:
    text = cmk005.ONE.replace("«ament_target_dependencies»", written)
    after = mended({**cmk005.FILES, "CMakeLists.txt": text}, "CMK005", "CMakeLists.txt")
    expected = "TARGET_LINK_LIBRARIES" if written.isupper() else "target_link_libraries"
    assert after == text.replace(written, expected).replace(
        "rclcpp std_msgs)", "PUBLIC rclcpp::rclcpp ${std_msgs_TARGETS})"
    )


@pytest.mark.parametrize(
    "made, rule, is_joined",
    [
        ("add_executable(a a.cpp)", "DESTINATION lib/${PROJECT_NAME}", True),
        ("add_executable(a a.cpp)", "EXPORT e DESTINATION lib/${PROJECT_NAME}", False),
        ("add_executable(a a.cpp)", "DESTINATION bin", False),
        ("add_library(a SHARED a.cpp)", "DESTINATION lib/${PROJECT_NAME}", False),
    ],
)
def test_an_executable_joins_a_rule_of_executables_alone(made: str, rule: str, is_joined: bool) -> None:
    lines = f"{made}\nadd_executable(b a.cpp)\ninstall(TARGETS a {rule})\n"
    files = {"package.xml": manifest("", "ament_cmake"), "a.cpp": "int main() {return 0;}\n"}
    after = mended(
        {**files, "CMakeLists.txt": CMAKE.replace("ament_package", lines + "ament_package")}, "CMK103", "CMakeLists.txt"
    )
    assert ("install(TARGETS a b " in after, "install(TARGETS b" in after) == (is_joined, not is_joined)


@pytest.mark.parametrize(
    "code, count",
    [
        ("'a = my_pkg.a:main'\n'b = my_pkg.b:main'", 1),
        ("'a = my_pkg.a:main'\n'b = my_pkg.b:main'\n'c = my_pkg.c:main'", 2),
        ("'a = my_pkg.a:main'\n'b'", 0),
        ("'a = my_pkg.a:mainb = my_pkg.b:main'", 0),
        ("'a = my_pkg.a:main'", 0),
    ],
)
def test_strings_are_parted_where_each_is_an_entry_point(code: str, count: int) -> None:
    setup = one({**BASE, "setup.py": setup_py(f"entry_points={{'console_scripts': [{code}]}},")}, SetupPy)
    (entry,) = setup.entry_points
    assert [edit.text for edit in separate_with_commas(setup, entry)] == [","] * count


@pytest.mark.parametrize("name, count", [("talker", 1), ("my-talker", 0)])
def test_a_command_for_the_shell_is_no_neighbour_of_a_node(name: str, count: int) -> None:
    files = {
        **BASE,
        "package.xml": manifest("  <exec_depend>rclpy</exec_depend>\n"),
        "setup.py": setup_py(scripts(f"{name} = my_pkg.talker:main")),
        "my_pkg/talker.py": NODE,
        "my_pkg/listener.py": NODE,
    }
    assert len(lint_files(files, ["SET106"]).findings) == count


@pytest.mark.parametrize(
    "modules, meant",
    [
        (["my_pkg.nodes.of.a.robot.talker"], "my_pkg.nodes.of.a.robot.talker"),
        (["my_pkg.nodes.of.a.robot.talker", "my_pkg.other.parts.of.it.talker"], None),
        (["my_pkg.nodes.of.a.robot.talker", "my_pkg.taker"], "my_pkg.nodes.of.a.robot.talker"),
        (["my_pkg.taker"], "my_pkg.taker"),
        (["my_pkg.something_else"], None),
        (["my_pkg.tolker"], None),
    ],
)
def test_the_module_that_an_entry_point_means(modules: list[str], meant: str | None) -> None:
    """`my_pkg.tolker` is started by another one."""
    package: Any = SimpleNamespace(
        setup=SimpleNamespace(entry_points=[SimpleNamespace(module="my_pkg.tolker")]),
        on_disk={each: f"{each.replace('.', '/')}.py" for each in ["my_pkg.tolker", *modules]},
        manifest=SimpleNamespace(depends_on=lambda _: True),
    )
    assert MissingModules(package).suggestion("my_pkg.talker") == meant


@pytest.mark.parametrize("package, folder, is_generated", [
    ("linked", "linked", True), ("my_pkg", "my_pkg", False), ("", "", False), ("my_pkg", "./linked", True),
])  # fmt: skip
def test_a_module_behind_a_link_may_be_there(package: str, folder: str, is_generated: bool) -> None:
    setup = SimpleNamespace(
        folder_of=lambda _: folder,
        package_dir={},
        kind=lambda path: "unknown" if path in ("linked", "/linked") else "folder",
        folder=SimpleNamespace(children={}),
    )
    model: Any = SimpleNamespace(setup=setup)
    assert MissingModules(model).may_be_generated(f"{package}.words".lstrip(".")) is is_generated


def test_a_plugin_for_nobody_says_what_to_do() -> None:
    at = SimpleNamespace(base="my_core", path="CMakeLists.txt", base_span=Span(0, 1))
    found: Any = SimpleNamespace(exported=at, description=SimpleNamespace(file="plugins.xml"), owners=(), base="")
    bases: Any = None
    hit = plg005.at_export(bases, found)
    assert hit.fix is None
    assert hit.message == (
        "`plugins.xml` is exported to `my_core`, which is no known package: nothing loads its plugins; "
        "export it to the package of the base class"
    )


def test_a_loader_of_no_package_says_what_to_do() -> None:
    loader = SimpleNamespace(names=("srv", "srv::Base"), package=SimpleNamespace(inner=Span(0, 1)), path="a.cpp")
    found: Any = SimpleNamespace(loader=loader, suggestion=None)
    hit = plg005.at_loader(found)
    assert hit.fix is None
    assert hit.message == (
        "`srv` is no known package: the loader of `srv::Base` throws when it is created; "
        "name the package of the base class"
    )


@pytest.mark.parametrize("name, is_said", [("", True), ("/**", False), ("/*", False), ("/", True), ("//a", True)])
def test_names_of_nodes_in_parameter_files(name: str, is_said: bool) -> None:
    assert (name_problem(name) is not None) is is_said


@pytest.mark.parametrize("included, names", [("a/x.hpp", {"src/a/x.hpp"}), ("x.hpp", {"src/a/x.hpp", "src/b/x.hpp"})])
def test_headers_of_one_name_are_told_apart_by_their_folders(included: str, names: set[str]) -> None:
    include, nothing = SimpleNamespace(path=included, is_angled=True), SimpleNamespace(includes=())
    files: Any = {
        "src/m.cpp": SimpleNamespace(includes=(include,)), "src/a/x.hpp": nothing, "src/b/x.hpp": nothing,
    }  # fmt: skip
    assert Inclusions(files).reached(["src/m.cpp"]) == {"src/m.cpp", *names}
    certain = Inclusions(files, only_certain=True).reached(["src/m.cpp"])
    assert certain == {"src/m.cpp", *(names if len(names) == 1 else ())}


@pytest.mark.parametrize("is_traced", [True, False])
def test_a_process_notes_what_it_asks_of_the_disk_where_its_parent_does(
    monkeypatch: pytest.MonkeyPatch, is_traced: bool
) -> None:
    given: list[tuple[Any, ...]] = []
    monkeypatch.setattr(process_pool, "ProcessPoolExecutor", lambda *_, initargs, **__: given.append(initargs))
    tree = MemoryTree.of({**BASE})
    if is_traced:
        disk_trace.start_trace()
    try:
        settings: Any = None
        process_pool.ProcessPool(tree, Scope(("",), frozenset({""}), "my_pkg"), Targets(), settings, 1)
    finally:
        if is_traced:
            disk_trace.stop_trace()
    assert [each[-1] for each in given] == [is_traced]

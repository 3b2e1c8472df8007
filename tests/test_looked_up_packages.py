"""Packages whose files installed code looks for (DEP116): what declares them, and what is told elsewhere."""

from __future__ import annotations

import pytest

from rospkg_cli.checks.looked_up_packages import may_be_elsewhere
from rospkg_cli.example import SETUP_CFG, SETUP_PY, manifest, scripts, setup_py
from rospkg_cli.package.package_facts import PackageFacts
from rospkg_cli.package.workspace import Workspace
from rospkg_cli.ros.distros import DISTROS
from rospkg_cli.ros.name_index import Index, dump
from rospkg_cli.ros.names import FetchedNames
from rospkg_cli.testing import lint_files

HEAD = "from ament_index_python import get_package_prefix, get_package_share_directory\n"
LOOKUP = "get_package_share_directory('nav2_bringup')\n"
NEEDS = "  <exec_depend>ament_index_python</exec_depend>\n  <exec_depend>ros2launch</exec_depend>\n"
MARKER = {"resource/my_pkg": "", "my_pkg/__init__.py": "", "setup.cfg": SETUP_CFG, "setup.py": SETUP_PY}


def told(text: str, depends: str = "", path: str = "my_pkg/talker.py", **more: str) -> list[tuple[str, str]]:
    files = {**MARKER, "package.xml": manifest(NEEDS + depends), path: HEAD + text, **more}
    return [(f.severity.value, f.message.split("`")[1]) for f in lint_files(files, ["DEP116"]).findings]


@pytest.mark.parametrize("text", [LOOKUP, LOOKUP + LOOKUP, "get_package_prefix('nav2_bringup')\n"])
def test_a_package_whose_files_are_looked_for_is_told_once(text: str) -> None:
    assert told(text) == [("warning", "nav2_bringup")]
    assert told(text, "  <exec_depend>nav2_bringup</exec_depend>\n") == []


@pytest.mark.parametrize(
    "text, path",
    [
        (LOOKUP, "test/test_talker.py"),
        ("get_package_share_directory('my_pkg')\n", "my_pkg/talker.py"),
        ("get_package_share_directory('nobodys_package')\n", "my_pkg/talker.py"),
        ("get_package_share_directory(name)\n", "my_pkg/talker.py"),
        (f"try:\n    {LOOKUP}except PackageNotFoundError:\n    pass\n", "my_pkg/talker.py"),
        (f"import nav2_bringup\n{LOOKUP}", "my_pkg/talker.py"),
    ],
)
def test_what_may_be_absent_or_is_told_elsewhere(text: str, path: str) -> None:
    assert told(text, path=path) == []


@pytest.mark.parametrize(
    "name, is_complete, found",
    [("acme_arm", False, True), ("acme_arm", True, False), ("Acme's", False, False), ("a", False, False)],
)
def test_a_package_that_a_repository_may_have_that_is_not_here(name: str, is_complete: bool, found: bool) -> None:
    index = FetchedNames(dump(Index("", "", tuple(each.name for each in DISTROS), {}, {})))
    around = Workspace((PackageFacts("a", "a"),), frozenset({"a"}), is_complete, index=index)
    assert may_be_elsewhere(around, name) == found


def test_what_a_launch_file_needs_as_well_is_told_there() -> None:
    launch = (
        "from launch import LaunchDescription\nfrom launch_ros.actions import Node\n\n\n"
        "def generate_launch_description():\n"
        "    return LaunchDescription([Node(package='nav2_bringup', executable='x')])\n"
    )
    assert told(LOOKUP, **{"launch/a.launch.py": launch}) == []


def test_what_comes_with_others_is_an_info() -> None:
    text = "get_package_share_directory('rviz_common')\n"
    assert told(text, "  <exec_depend>rviz2</exec_depend>\n") == [("info", "rviz_common")]
    assert [level for level, _ in told(LOOKUP, "  <!-- <exec_depend>nav2_bringup</exec_depend> -->\n")] == ["info"]


LIBRARY = """\
from ament_index_python import get_package_share_directory


def share():
    return get_package_share_directory('arm')


def limits():
    return share() + '/limits.yaml'


def name():
    return 'arm'
"""
LAUNCH = "from lib.helpers import {}\n\n\ndef generate_launch_description():\n    pass\n"


def python_package(name: str, depends: str = "", **files: str) -> dict[str, str]:
    own = {f"{name}/__init__.py": "", f"resource/{name}": "", "setup.cfg": SETUP_CFG, "setup.py": SETUP_PY, **files}
    texts = {path: text.replace("my_pkg", name) for path, text in own.items()}
    return {f"{name}/{path}": text for path, text in {**texts, "package.xml": manifest(depends, name=name)}.items()}


def from_library(users: dict[str, tuple[str, str]], **more: str) -> list[tuple[str, str]]:
    """Return level and end of what is said of a library, by what others import of it and declare."""
    files = {**python_package("arm"), **python_package("lib", NEEDS, **{"lib/helpers.py": LIBRARY, **more})}
    for name, (taken, depends) in users.items():
        files |= python_package(name, depends, **{"launch/a.launch.py": LAUNCH.format(taken)})
    found = lint_files(files, ["DEP116"]).findings
    return [(each.severity.value, each.message.rpartition("; ")[2]) for each in found]


HAS_ARM = "  <exec_depend>arm</exec_depend>\n"
UNSHOWN = "comes to this line"
ADD = "add <exec_depend>arm</exec_depend>"


@pytest.mark.parametrize(
    ("users", "level", "end"),
    [
        ({"arm": ("limits", "")}, "info", "would make a circle: let those declare it who call this"),
        ({"arm": ("name", "")}, "info", UNSHOWN),
        ({"one": ("limits", HAS_ARM), "two": ("name", "")}, "info", "declares or uses it"),
        ({"one": ("limits", HAS_ARM), "two": ("share", "")}, "warning", ADD),
        ({"one": ("name", HAS_ARM)}, "info", UNSHOWN),
        ({}, "info", UNSHOWN),
    ],
)
def test_what_a_library_looks_for_in_the_name_of_its_users(
    users: dict[str, tuple[str, str]], level: str, end: str
) -> None:
    ((found, said),) = from_library(users)
    assert (found, said.endswith(end)) == (level, True), said


def test_a_library_with_a_program_of_its_own_looks_for_itself() -> None:
    program = "from .helpers import limits\n\n\ndef main():\n    print(limits())\n"
    setup = setup_py(scripts("show = lib.show:main"))
    ((level, _),) = from_library({"arm": ("limits", "")}, **{"lib/show.py": program, "setup.py": setup})
    assert level == "warning"


@pytest.mark.parametrize(("taken", "level"), [("name", "info"), ("share", "warning"), ("*", "warning")])
def test_a_library_may_use_what_else_the_module_has(taken: str, level: str) -> None:
    builder = f"from lib.helpers import {taken}\n"
    ((found, _),) = from_library({"one": ("limits", HAS_ARM)}, **{"lib/builder.py": builder})
    assert found == level


@pytest.mark.parametrize(("starts", "level"), [("arm", "info"), ("other", "warning")])
def test_a_user_that_starts_what_the_library_looks_for_needs_it_anyway(starts: str, level: str) -> None:
    files = {**python_package("arm"), **python_package("lib", NEEDS, **{"lib/helpers.py": LIBRARY})}
    user = {"launch/a.launch.py": LAUNCH.format("limits"), "launch/b.launch.xml": STARTS.format(starts)}
    files |= python_package("one", "", **user)
    (only,) = lint_files(files, ["DEP116"]).findings
    assert only.severity.value == level


STARTS = "<launch>\n  <node pkg='{}' exec='talker'/>\n</launch>\n"


@pytest.mark.parametrize(("starts", "level"), [("my_pkg", "info"), ("nav2_bringup", "warning")])
def test_a_package_that_starts_this_ones_programs_is_not_to_be_declared_by_it(starts: str, level: str) -> None:
    lookup = f"{HEAD}A = get_package_share_directory('app')"
    own = {**MARKER, "package.xml": manifest(NEEDS), "my_pkg/talker.py": lookup}
    other = {"package.xml": manifest().replace("my_pkg<", "app<", 1), "launch/app.launch.xml": STARTS.format(starts)}
    other |= {"resource/app": "", "setup.py": SETUP_PY.replace("my_pkg", "app")}
    files = {f"one/{path}": text for path, text in own.items()} | {f"app/{path}": text for path, text in other.items()}
    (only,) = lint_files(files, ["DEP116"]).findings
    assert only.severity.value == level
    assert ("circle" in only.message) == (only.fix is None) == (level == "info")

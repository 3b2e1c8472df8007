"""Packages whose files installed code looks for (DEP116): what declares them, and what is told elsewhere."""

from __future__ import annotations

import pytest

from rospkg_cli.checks.looked_up_packages import may_be_elsewhere
from rospkg_cli.example import SETUP_CFG, SETUP_PY, manifest
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

"""A file that a launch file names only where a search finds no such file, which it prints, is an info (LCH003)."""

from __future__ import annotations

import pytest

from rospkg_cli.example import CMAKE, manifest
from rospkg_cli.testing import lint_files

LAUNCH = """\
import glob
import os
from pathlib import Path

from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch.actions import OpaqueFunction
from launch_ros.actions import Node


def setup(context):
    share = get_package_share_directory('my_pkg')
    folder = os.path.join(share, 'runs')
{body}
    return [Node(package='nav_tools', executable='player', parameters=[{{'run_file': path}}])]


def generate_launch_description():
    return LaunchDescription([OpaqueFunction(function=setup)])
"""
PACKAGE = {
    "package.xml": manifest("  <exec_depend>ros2launch</exec_depend>\n", "ament_cmake"),
    "CMakeLists.txt": CMAKE.replace(
        "ament_package", "install(DIRECTORY launch DESTINATION share/my_pkg)\nament_package"
    ),
}
SEARCH = "found = sorted(glob.glob(os.path.join(folder, 'run_*.bin')))"
LAST = "os.path.join(folder, 'run_last.bin')"
SAYS = "print('no runs in', folder, '- record one first')"
WHY = "but only where a search finds no such file, which the launch then prints"


def told(*lines: str) -> list[str]:
    body = "\n".join(f"    {line}" for line in lines)
    found = lint_files({**PACKAGE, "launch/a.launch.py": LAUNCH.format(body=body)}, ["LCH003"]).findings
    return [f"{each.severity.value}: {each.message}" for each in found]


def either(test: str, there: list[str], none: list[str]) -> list[str]:
    return [f"if {test}:", *(f"    {each}" for each in there), "else:", *(f"    {each}" for each in none)]


TAKE, LACK = ["path = found[-1]"], [f"path = {LAST}", SAYS]


@pytest.mark.parametrize(
    "lines",
    [
        [SEARCH, *either("found", TAKE, LACK)],
        [SEARCH, *either("len(found) > 0", TAKE, LACK)],
        [SEARCH, *either("not found", LACK, TAKE)],
        [SEARCH, *either("len(found) == 0", LACK, TAKE)],
        ["found = [f for f in os.listdir(folder) if f.endswith('.bin')]", *either("found", TAKE, LACK)],
        ["found = list(Path(folder).glob('run_*.bin'))", *either("found", TAKE, LACK)],
        ["pattern = os.path.join(folder, '*.bin')", "found = glob.glob(pattern)", *either("found", TAKE, LACK)],
        ["try:", f"    {SEARCH}", "    path = found[-1]", "except IndexError:", *(f"    {each}" for each in LACK)],
    ],
)  # fmt: skip
def test_what_is_named_where_a_search_finds_none(lines: list[str]) -> None:
    (text,) = told(*lines)
    assert text.startswith("info: ")
    assert WHY in text


OTHER = "os.path.join(share, 'maps', 'run_last.bin')"


@pytest.mark.parametrize(
    "lines",
    [
        [SEARCH, *either("found", TAKE, LACK[:1])],
        [SEARCH, *either("found", TAKE, [f"path = {OTHER}", SAYS])],
        [SEARCH, *either("found", TAKE, ["path = os.path.join(folder, 'default.bin')", SAYS])],
        [SEARCH, *either("found", LACK, TAKE)],
        [SEARCH, *either("len(found) == 1", LACK, TAKE)],
        [SEARCH, "found = [] or found", *either("context", TAKE, LACK)],
    ],
)
def test_what_is_named_without_such_a_search(lines: list[str]) -> None:
    (text,) = told(*lines)
    assert text.startswith("warning: ")
    assert WHY not in text

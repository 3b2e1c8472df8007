"""A path that a launch file only prints is opened by nobody: what is missing there is an info (LCH003)."""

from __future__ import annotations

import pytest

from rospkg_cli.example import manifest
from rospkg_cli.testing import lint_files

LAUNCH = """\
import os

from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    view = os.path.join(get_package_share_directory('my_pkg'), 'rviz', 'view.rviz')
    LINE
    rviz = Node(package='rviz2', executable='rviz2', arguments=['-d', view])
    other = Node(package='turtlesim', executable='turtlesim_node')
    return LaunchDescription([other, MORE])
"""
FILES = {
    "package.xml": manifest("  <exec_depend>ros2launch</exec_depend>\n  <exec_depend>rviz2</exec_depend>\n"),
    "setup.py": "from setuptools import setup\n\nsetup(name='my_pkg', version='0.1.0', packages=['my_pkg'])\n",
    "my_pkg/__init__.py": "",
}
SHOWS = (
    "print(view)",
    "print('view:', view)",
    "print('view: ' + str(view))",
    "print('view: %s' % view)",
    "print('view: {}'.format(view))",
    "print(f'view: {view}')",
)
USES = ("print(open(view).read())", "view = check(view)", "print(load(view))", "view and print('there')")


def levels(line: str, more: str = "") -> list[str]:
    text = LAUNCH.replace("LINE", line).replace("MORE", more)
    return [each.severity.value for each in lint_files({**FILES, "launch/a.launch.py": text}, ["LCH003"]).findings]


@pytest.mark.parametrize("line", SHOWS)
def test_what_is_printed_and_given_to_no_action_is_an_info(line: str) -> None:
    assert levels(line) == ["info"]
    assert "info" not in levels(line, "rviz")


@pytest.mark.parametrize("line", USES)
def test_what_is_used_beside_is_no_info(line: str) -> None:
    assert "info" not in levels(line)

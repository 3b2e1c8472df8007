"""What `Command` makes of its list: one text without blanks between the parts."""

from __future__ import annotations

import pytest

from rospkg_cli.example import manifest
from rospkg_cli.testing import lint_files

TEXT = """\
import os
from launch import LaunchDescription
from launch.actions import LogInfo
from launch.substitutions import Command, FindExecutable, LaunchConfiguration, PathJoinSubstitution
from launch_ros.substitutions import FindPackageShare
from ament_index_python.packages import get_package_share_directory


def generate_launch_description():
    share = get_package_share_directory('my_pkg')
    file = os.path.join(share, 'urdf', 'a.xacro')
    return LaunchDescription([LogInfo(msg=Command({}))])
"""


@pytest.mark.parametrize(
    ("command", "count"),
    [
        ("['xacro', file]", 1),
        ("['xacro', str(file)]", 1),
        ("['xacro', PathJoinSubstitution([FindPackageShare('my_pkg'), 'a.xacro'])]", 1),
        ("['xacro', '/opt/a.xacro']", 1),
        ("['xacro ', file]", 0),
        ("['xacro', ' ', file]", 0),
        ("['xacro', ' ' + file]", 0),
        ("['xacro --inorder', file]", 0),
        ("['/opt/ros/bin/', LaunchConfiguration('program')]", 0),
        ("[FindExecutable(name='xacro'), ' ', file]", 0),
        ("['xacro', os.environ['FILE']]", 0),
        ("['xacro']", 0),
        ("'xacro a.xacro'", 0),
    ],
)
def test_a_program_without_a_blank_behind_it(command: str, count: int) -> None:
    files = {
        "package.xml": manifest("  <exec_depend>ros2launch</exec_depend>\n"),
        "launch/a.launch.py": TEXT.replace("{}", command),
    }
    found = [each for each in lint_files(files, ["LCH014"]).findings if "puts no blanks" in each.message]
    assert [(each.severity.value, "write `'xacro '`" in each.message) for each in found] == [("error", True)] * count

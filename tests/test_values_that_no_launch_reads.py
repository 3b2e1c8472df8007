"""What a launch file makes and nothing reads or visits is met by nobody today: an info, whichever rule tells of it."""

from __future__ import annotations

import pytest

from rospkg_cli.example import manifest
from rospkg_cli.testing import lint_files

HEAD = """\
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, LogInfo
from launch.conditions import IfCondition
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node


def generate_launch_description():
    {}
"""


def levels(code: str, *lines: str) -> list[str]:
    files = {"package.xml": manifest(""), "launch/a.launch.py": HEAD.format("\n    ".join(lines))}
    return [f"{each.severity.value}: {each.message}" for each in lint_files(files, [code]).findings]


DECLARED = "parts = [DeclareLaunchArgument('robot_file', default_value='a'), *unknown()]"


@pytest.mark.parametrize(
    ("value", "level"),
    [("LaunchConfiguration('robot_fil')", "warning"), ("LaunchConfiguration('robot_fil', default='b')", "warning")],
)
def test_a_configuration_that_nothing_reads(value: str, level: str) -> None:
    (read,) = levels("LCH008", DECLARED, f"path = {value}", "return LaunchDescription([*parts, LogInfo(msg=path)])")
    assert read.startswith(level)
    (lost,) = levels("LCH008", DECLARED, f"path = {value}", "return LaunchDescription(parts)")
    assert lost.startswith("info: no file declares the launch argument `robot_fil`")
    assert "as soon as something reads the variable" in lost


WORDS = "Node(package='p', executable='e', arguments=['--x' 'left'])"
TEXT = "DeclareLaunchArgument('name', default_value=f'{LaunchConfiguration(\"a\")}_base')"
TYPES = "Node(package='ros_gz_bridge', executable='parameter_bridge', arguments=['/a@std_msgs/msg/Strin@gz.msgs.X'])"


@pytest.mark.parametrize(("code", "action"), [("LCH014", WORDS), ("LCH019", TYPES)])
def test_an_action_that_nothing_adds(code: str, action: str) -> None:
    (added,) = levels(code, f"one = {action}", "return LaunchDescription([one])")
    assert added.startswith("warning")
    (left,) = levels(code, f"one = {action}", "return LaunchDescription([])")
    assert left.startswith("info")
    assert "but nothing adds the action" in left


def test_bridges_that_are_off_by_default() -> None:
    off = TYPES.replace("])", "], condition=IfCondition(LaunchConfiguration('gui')))")
    argument = "gui = DeclareLaunchArgument('gui', default_value='{}')"
    for default, level in (("false", "info"), ("true", "warning")):
        (found,) = levels("LCH019", argument.format(default), f"return LaunchDescription([gui, {off}])")
        assert found.startswith(level)


@pytest.mark.parametrize(("more", "level"), [("", "info"), (", LogInfo(msg=LaunchConfiguration('name'))", "warning")])
@pytest.mark.parametrize(
    ("code", "text"),
    [("LCH014", TEXT), ("LCH021", "DeclareLaunchArgument('name', default_value=os.path.join('maps', '/a.yaml'))")],
)
def test_the_default_of_an_argument_that_nothing_reads(code: str, text: str, more: str, level: str) -> None:
    (found,) = levels(code, "import os", f"return LaunchDescription([{text}{more}])")
    assert found.startswith(level)


def test_a_package_whose_build_cannot_be_read_is_told_all_the_same() -> None:
    text = HEAD.format(f"return LaunchDescription([{WORDS}])")
    files = {"package.xml": manifest("", "ament_cmake"), "CMakeLists.txt": "project(a\n", "launch/a.launch.py": text}
    assert [each.severity.value for each in lint_files(files, ["LCH014"]).findings] == ["warning"]

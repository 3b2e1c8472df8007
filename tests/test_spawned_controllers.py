"""Controllers that launch files load under the name of their package (DEP103)."""

from __future__ import annotations

import pytest

from rospkg_cli.example import manifest
from rospkg_cli.testing import lint_files

STARTS = """\
from launch import LaunchDescription
from launch.actions import ExecuteProcess
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription([{}])
"""
SPAWNER = "Node(package='controller_manager', executable='{}', arguments=['{}', '-c', '/controller_manager'])"
INSTALLS = (
    "project(my_pkg)\nfind_package(ament_cmake REQUIRED)\n"
    "install(DIRECTORY config launch DESTINATION share/${PROJECT_NAME})\nament_package()\n"
)
NEEDS = "  <exec_depend>controller_manager</exec_depend>\n  <exec_depend>ros2launch</exec_depend>\n"


def told(action: str, depends: str = "", **files: str) -> list[tuple[str, str]]:
    written = {
        "CMakeLists.txt": INSTALLS,
        "package.xml": manifest(NEEDS + depends, "ament_cmake"),
        "launch/a.launch.py": STARTS.format(action),
        **files,
    }
    found = lint_files(written, ["DEP103", "DEP106"]).findings
    return [(each.severity.value, each.message.split("`")[1]) for each in found]


@pytest.mark.parametrize(
    "action",
    [
        SPAWNER.format("spawner", "joint_state_broadcaster"),
        SPAWNER.format("spawner.py", "joint_state_broadcaster"),
        "ExecuteProcess(cmd=['ros2', 'control', 'load_controller', 'joint_state_broadcaster'])",
    ],
)
def test_a_controller_of_a_well_known_name_needs_its_package(action: str) -> None:
    assert ("info", "joint_state_broadcaster") in told(action)
    declared = "  <exec_depend>ros2_controllers</exec_depend>\n  <exec_depend>ros2controlcli</exec_depend>\n"
    assert told(action, declared) == []


@pytest.mark.parametrize(
    "action",
    [
        SPAWNER.format("spawner", "arm_controller"),
        SPAWNER.format("ros2_control_node", "joint_state_broadcaster"),
        SPAWNER.format("spawner", "joint_state_broadcaster").replace("package='controller_manager'", "package='xacro'"),
        "ExecuteProcess(cmd=['ros2', 'control', 'list_controllers', 'joint_state_broadcaster'])",
    ],
)
def test_other_names_and_programs_are_left_alone(action: str) -> None:
    assert "joint_state_broadcaster" not in [name for _, name in told(action)]


def test_a_controller_of_the_parameters_is_told_there_alone() -> None:
    parameters = (
        "controller_manager:\n  ros__parameters:\n    joint_state_broadcaster:\n"
        "      type: joint_state_broadcaster/JointStateBroadcaster\n"
    )
    action = SPAWNER.format("spawner", "joint_state_broadcaster")
    assert told(action, **{"config/a.yaml": parameters}) == [("info", "joint_state_broadcaster")]


@pytest.mark.parametrize("command", ["'ros2', 'bag', 'record', '-a'", "'ros2 bag record -a'"])
def test_a_command_of_ros2_needs_its_package(command: str) -> None:
    action = f"ExecuteProcess(cmd=[{command}])"
    assert told(action) == [("info", "ros2bag")]
    assert told(action, "  <exec_depend>ros2bag</exec_depend>\n") == []
    assert told(action.replace("bag", "nothing")) == []

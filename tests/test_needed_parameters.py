"""What robot_state_publisher and servers of nav2 need to start (PRM008)."""

from __future__ import annotations

import pytest

from rospkg_cli.example import manifest
from rospkg_cli.testing import lint_files

LAUNCH = """\
import launch_ros
from launch import LaunchDescription
from launch.conditions import IfCondition
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import LoadComposableNodes, Node
from launch_ros.descriptions import ComposableNode
from launch_ros.substitutions import FindPackageShare

x = LaunchConfiguration('x')
share = FindPackageShare('my_pkg')


def generate_launch_description():
    return LaunchDescription([{}])
"""
ROBOT = "Node(package='robot_state_publisher', executable='robot_state_publisher'{})"
MAP = "Node(package='nav2_map_server', executable='map_server', name='map_server'{})"
NAMES = "Node(package='nav2_lifecycle_manager', executable='lifecycle_manager'{})"
PART = (
    "LoadComposableNodes(target_container='c', composable_node_descriptions=["
    "ComposableNode(package='nav2_map_server', plugin='nav2_map_server::MapServer'{})])"
)
FILES = {
    "package.xml": manifest("", "ament_cmake"),
    "CMakeLists.txt": "project(my_pkg)\nfind_package(ament_cmake REQUIRED)\n"
    "install(DIRECTORY config launch DESTINATION share/${PROJECT_NAME})\nament_package()\n",
    "config/map.yaml": "map_server:\n  ros__parameters:\n    yaml_filename: a.yaml\n",
    "config/other.yaml": "map_server:\n  ros__parameters:\n    use_sim_time: true\n",
}


def told(action: str, **others: str) -> list[str]:
    files = {**FILES, "launch/a.launch.py": LAUNCH.replace("{}", action), **others}
    return [f"{each.severity.value} {each.message.split('`')[1]}" for each in lint_files(files, ["PRM008"]).findings]


@pytest.mark.parametrize(
    ("action", "name"),
    [
        (ROBOT.format(""), "robot_description"),
        (ROBOT.format(", parameters=[{'use_sim_time': x}], remappings=[('a', 'b')]"), "robot_description"),
        (MAP.format(""), "yaml_filename"),
        (MAP.format(", condition=IfCondition(x)"), "yaml_filename"),
        (MAP.format(", arguments=['--ros-args', '--log-level', 'info']"), "yaml_filename"),
        (MAP.format(", parameters=[[share, '/config/other.yaml']]"), "yaml_filename"),
        (NAMES.format(", parameters=[{'autostart': True}]"), "node_names"),
        (PART.format(""), "yaml_filename"),
    ],
)
def test_a_node_that_does_not_get_what_it_needs(action: str, name: str) -> None:
    assert told(action) == [f"warning {name}"]


@pytest.mark.parametrize(
    "action",
    [
        ROBOT.format(", parameters=[{'robot_description': x}]"),
        ROBOT.format(", parameters=[{'use_robot_description_topic': True}]"),
        ROBOT.format(", parameters=[x]"),
        ROBOT.format(", parameters=[{x: 'a'}]"),
        ROBOT.format(", arguments=['a.urdf']"),
        ROBOT.format(", parameters=[{**x}]"),
        ROBOT.format(", **x"),
        MAP.format(", parameters=[[share, '/config/map.yaml']]"),
        MAP.format(", parameters=[[share, '/config/', x]]"),
        MAP.format(", parameters=['/somewhere/map.yaml']"),
        MAP.format(", arguments=['--ros-args', '-p', 'yaml_filename:=a.yaml']"),
        MAP.format(", arguments=['--ros-args', '--params-file', x]"),
        "launch_ros.actions.SetParameter('yaml_filename', x), " + MAP.format(""),
        NAMES.format(", parameters=[{'autostart': True}, {'node_names': x}]"),
        PART.format(", parameters=[x]"),
    ],
)
def test_a_node_that_may_get_it(action: str) -> None:
    assert told(action) == []


def test_another_launch_file_may_give_parameters_to_all() -> None:
    other = '<launch><set_parameter name="robot_description" value="a"/></launch>\n'
    assert told(ROBOT.format(""), **{"launch/b.launch.xml": other}) == []


def test_a_node_of_the_workspace_may_need_nothing() -> None:
    files = {f"a/{path}": text for path, text in FILES.items()}
    files["a/launch/a.launch.py"] = LAUNCH.replace("{}", ROBOT.format(""))
    own = {"b/package.xml": manifest("", "ament_cmake", "robot_state_publisher")}
    assert len(lint_files(files, ["PRM008"]).findings) == 1
    assert not lint_files({**files, **own}, ["PRM008"]).findings

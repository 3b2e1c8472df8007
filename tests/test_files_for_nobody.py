"""Parameter files that no node gets, as the included launch file has no such argument; blocks of sleeping servers."""

from __future__ import annotations

import pytest

from rospkg_cli.example import CMAKE, manifest
from rospkg_cli.testing import lint_files

INSTALL = "install(DIRECTORY config launch DESTINATION share/${PROJECT_NAME})\nament_package"
PYTHON = """\
import os

from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch.actions import IncludeLaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    path = os.path.join(get_package_share_directory('my_pkg'), 'config', 'a.yaml')
    print('the file:', path)
    unused = Node(package='slam_toolbox', executable='sync_slam_toolbox_node', name='slam_toolbox', parameters=[path])
    return LaunchDescription([
        IncludeLaunchDescription(
            os.path.join(get_package_share_directory('slam_toolbox'), 'launch', 'online_async_launch.py'),
            launch_arguments={{'{argument}': {path}, 'use_sim_time': 'true'}}.items(),
        ),
        {more}
    ])
"""
WHOLE = "os.path.join(get_package_share_directory('my_pkg'), 'config', 'a.yaml')"
INCLUDE = """\
        IncludeLaunchDescription(
            os.path.join(get_package_share_directory('other'), 'launch', 'other.launch.py'),
        ),
"""
SLAM = "slam_toolbox:\n  ros__parameters:\n    transform_timeout: 0.2 // seconds\n    map_frame: map\n"


def package(launch: str, yaml: str, path: str) -> dict[str, str]:
    return {
        "package.xml": manifest("  <exec_depend>slam_toolbox</exec_depend>\n", "ament_cmake"),
        "CMakeLists.txt": CMAKE.replace("ament_package", INSTALL),
        "config/a.yaml": yaml,
        path: launch,
    }


@pytest.mark.parametrize(
    ("argument", "path", "more", "level"),
    [
        ("params_file", WHOLE, "", "info"),
        ("params_file", "path", "", "info"),
        ("slam_params_file", WHOLE, "", "warning"),
        ("params_file", WHOLE, INCLUDE, "warning"),
        ("params_file", WHOLE, "ExecuteProcess(cmd=['ros2', 'param', 'load', '/slam_toolbox', path]),", "warning"),
    ],
)
def test_a_file_for_an_argument_that_is_not_there(argument: str, path: str, more: str, level: str) -> None:
    launch = PYTHON.format(argument=argument, path=path, more=more)
    (found,) = lint_files(package(launch, SLAM + "    resolution: 0.05\n", "launch/a.launch.py"), ["PRM006"]).findings
    assert found.severity.value == level


@pytest.mark.parametrize(("argument", "level"), [("param_file", "info"), ("params_file", "warning")])
def test_a_file_for_an_argument_that_is_not_there_in_xml(argument: str, level: str) -> None:
    launch = (
        '<launch>\n  <include file="$(find-pkg-share nav2_bringup)/launch/navigation_launch.py">\n'
        f'    <arg name="{argument}" value="$(find-pkg-share my_pkg)/config/a.yaml"/>\n  </include>\n</launch>\n'
    )
    yaml = "controller_server:\n  ros__parameters:\n    controller_frequency: 20\n"
    yaml += "".join(
        f"{name}:\n  ros__parameters:\n    use_sim_time: true\n" for name in ("planner_server", "bt_navigator")
    )
    (found,) = lint_files(package(launch, yaml, "launch/a.launch.xml"), ["PRM006"]).findings
    assert found.severity.value == level


SERVERS = """\
import os

from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    path = os.path.join(get_package_share_directory('my_pkg'), 'config', 'a.yaml')
    return LaunchDescription([
        Node(package='nav2_behaviors', executable='behavior_server', parameters=[path]),
        Node(package='nav2_collision_monitor', executable='collision_monitor', parameters=[path]),
        {manager}
    ])
"""
MANAGER = (
    "Node(package='nav2_lifecycle_manager', executable='lifecycle_manager', parameters=[{{'autostart': True, "
    "'node_names': [{}]}}]),"
)
MONITOR = """\
collision_monitor:
  ros__parameters:
    base_frame_id: base_footprint
    odom_frame_id: odom
    source_timeout: 1.0
    polygons: [Stop]
    Stop:
      type: polygon
      action_type: stop
      sources: [scan]
"""


@pytest.mark.parametrize(
    ("manager", "level"),
    [
        (MANAGER.format("'behavior_server'"), "info"),
        (MANAGER.format("'behavior_server', 'collision_monitor'"), "warning"),
        ("", "warning"),
    ],
)
def test_a_server_that_no_lifecycle_manager_has(manager: str, level: str) -> None:
    files = package(SERVERS.format(manager=manager), MONITOR, "launch/a.launch.py")
    (found,) = lint_files(files, ["PRM007"]).findings
    assert found.severity.value == level
    assert "`nav2_collision_monitor` declares no parameter `Stop.sources`" in found.message

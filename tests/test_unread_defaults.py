"""A file in a default of xacro that only what is off by default reads: nobody misses it (URD002)."""

from __future__ import annotations

import pytest

from rospkg_cli.example import CMAKE, manifest
from rospkg_cli.testing import lint_files

INSTALL = CMAKE.replace("ament_package", "install(DIRECTORY {} DESTINATION share/${{PROJECT_NAME}})\nament_package")
ROBOT = """\
<robot xmlns:xacro="http://www.ros.org/wiki/xacro" name="rover">
  <xacro:arg name="sim" default="false"/>
  <xacro:arg name="controllers" default="$(find rover_control)/config/controllers.yaml"/>
  <link name="base"/>
  {}
</robot>
"""
PLUGIN = '<gazebo><plugin name="a" filename="b"><parameters>$(arg controllers)</parameters></plugin></gazebo>'
OFF = f'<xacro:if value="$(arg sim)">{PLUGIN}</xacro:if>'
START = """\
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch.substitutions import Command, LaunchConfiguration
from launch_ros.actions import Node


def generate_launch_description():
    robot = Command(['xacro ', get_package_share_directory('rover_description'), '/urdf/rover.urdf.xacro'{}])
    return LaunchDescription([
        {}
        Node(package='robot_state_publisher', executable='robot_state_publisher',
             parameters=[{{'robot_description': robot}}]),
        Node(package='ros_gz_sim', executable='create', arguments=['-topic', 'robot_description']),
    ])
"""
GIVEN = "' sim:=', LaunchConfiguration('sim')"


def told(body: str, start: str, other: str) -> list[str]:
    """Return the levels of what is told of a robot that two packages start, with their launch files."""
    files = {
        "rover_description/urdf/rover.urdf.xacro": ROBOT.format(body),
        "rover_description/launch/show.launch.py": start,
        "rover_control/launch/control.launch.py": other,
    }
    for name, folders in (("rover_description", "urdf launch"), ("rover_control", "launch")):
        files[f"{name}/package.xml"] = manifest("", "ament_cmake").replace("my_pkg", name)
        files[f"{name}/CMakeLists.txt"] = INSTALL.format(folders).replace("my_pkg", name)
    return [each.severity.value for each in lint_files(files, ["URD002"]).findings]


def declared(value: str) -> str:
    return START.format(f", {GIVEN}", f"DeclareLaunchArgument('sim', default_value='{value}'),")


SHOWN = declared("true").replace("ros_gz_sim", "rviz2")
LOADED = (
    START.replace("Command(['xacro ', ", "loaded(")
    .replace("{}])\n", "{})\n")
    .format(", sim=LaunchConfiguration('sim'), controllers=made", "")
)


@pytest.mark.parametrize(
    ("body", "start", "other", "level"),
    [
        (OFF, declared("false"), declared("false"), "info"),
        (OFF, declared("false"), START.format(", ' sim:=false'", ""), "info"),
        (OFF, declared("false"), START.format(", ' sim:=true'", ""), "warning"),
        (OFF, declared("true"), declared("false"), "warning"),
        (OFF, declared("false"), START.format(f", {GIVEN}", ""), "warning"),
        (PLUGIN, declared("false"), declared("false"), "warning"),
        (OFF, SHOWN, LOADED, "info"),
        (PLUGIN, SHOWN, LOADED, "info"),
        (PLUGIN, LOADED, declared("false"), "warning"),
        (PLUGIN.replace("gazebo", "link"), SHOWN, LOADED, "warning"),
        (OFF + PLUGIN, declared("false"), declared("false"), "warning"),
    ],
)
def test_a_default_is_met_where_something_reads_it(body: str, start: str, other: str, level: str) -> None:
    assert told(body, start, other) == [level]

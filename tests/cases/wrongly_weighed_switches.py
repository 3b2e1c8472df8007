"""Includes behind a switch that robots turn on by default, and launch files give otherwise (URD002)."""

from __future__ import annotations

from rospkg_cli.example import CMAKE, Example, manifest

ROBOT = """\
<robot xmlns:xacro="http://www.ros.org/wiki/xacro" name="robot">
  <xacro:arg name="with_control" default="true"/>
  <xacro:if value="$(arg with_control)">
    <xacro:include filename="control.xacro"/>
  </xacro:if>
  <xacro:unless value="${{1 == 1}}"/>
  <link name="base"/>
</robot>
"""
LAUNCH = """\
import os
from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch.substitutions import Command, LaunchConfiguration
from launch_ros.actions import Node


def generate_launch_description():
    robot = os.path.join(get_package_share_directory('my_pkg'), 'urdf', 'robot.urdf.xacro')
    control = LaunchConfiguration('with_control')
    text = Command(['xacro ', robot{}])
    return LaunchDescription([
        DeclareLaunchArgument('with_control', default_value='{}'),
        Node(package='robot_state_publisher', executable='robot_state_publisher', parameters=[{{'a': text}}]),
    ])
"""
GIVES = ", ' with_control:=', control"
NEEDED = ("ament_index_python", "launch", "launch_ros", "robot_state_publisher", "ros2launch", "xacro")
XML = """\
<launch>
  <include file="$(find-pkg-share my_pkg)/launch/a.launch.py">
    <arg name="with_control" value="{}"/>
  </include>
</launch>
"""


def robot(given: str, default: str, **more: str) -> Example:
    install = "install(DIRECTORY launch urdf DESTINATION share/my_pkg)\nament_package"
    files = {
        "package.xml": manifest("".join(f"  <exec_depend>{each}</exec_depend>\n" for each in NEEDED), "ament_cmake"),
        "CMakeLists.txt": CMAKE.replace("ament_package", install),
        "urdf/robot.urdf.xacro": ROBOT.format(),
        "launch/a.launch.py": LAUNCH.format(given, default),
        **{f"launch/{name}.launch.xml": text for name, text in more.items()},
    }
    return Example(bad=files, good={}, on="ament_cmake")


CASES = {
    "URD002": (
        robot(GIVES, "false"),
        robot(GIVES, "true"),
        robot("", "false"),
        robot(GIVES, "false", b=XML.format("true")),
        robot(GIVES, "false", b=XML.format("false")),
    ),
}

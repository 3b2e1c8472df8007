"""What xacro takes, and what is filled in by others than xacro (URD001, URD002)."""

from __future__ import annotations

from rospkg_cli.example import CMAKE, Example, manifest

HEAD = '<robot xmlns:xacro="http://www.ros.org/wiki/xacro" name="robot">\n'
JOINT = """\
  <link name="base"/>
  <link name="arm"/>
  <joint name="arm_joint" type="fixed">
    <parent link="base"/>
    <child link="arm"/>
    <origin xyz="0\t0
      1"/>
  </joint>
</robot>
"""
INCLUDES = """\
  <xacro:include filename="$(find my_pkg)/urdf/own.xacro" optional="true"/>
  <xacro:include filename="own.xacro" optional="true"/>
  <xacro:include filename="others.xacro"/>
  <link name="base"/>
</robot>
"""
GAZEBO = """\
  <link name="base"/>
  <gazebo><plugin name="a"><parameters>$(find my_pkg)/urdf/none.yaml</parameters></plugin></gazebo>
</robot>
"""
TEMPLATE = '<robot name="robot">\n  <link name="${NAME}"/>\n</robot>\n'
FILLS = """\
import os
from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    path = os.path.join(get_package_share_directory('my_pkg'), 'urdf', 'robot.urdf')
    text = {}
    publisher = Node(package='robot_state_publisher', executable='robot_state_publisher', parameters=[{{'a': text}}])
    return LaunchDescription([publisher])
"""
READ = "open(path).read().replace('${NAME}', 'base')"
EXPANDED = "os.popen('xacro ' + path).read()"
SHOW = """\
<launch>
  <let name="model" value="$(find-pkg-share my_pkg)/urdf/{}"/>
  <node pkg="{}" exec="{}"/>
</launch>
"""
NEEDED = ("ament_index_python", "launch", "launch_ros", "robot_state_publisher", "ros2launch", "xacro")


def robot(text: str, name: str, **launch: str) -> Example:
    install = "install(DIRECTORY launch urdf DESTINATION share/my_pkg)\nament_package"
    files = {
        "package.xml": manifest("".join(f"  <exec_depend>{each}</exec_depend>\n" for each in NEEDED), "ament_cmake"),
        "CMakeLists.txt": CMAKE.replace("ament_package", install),
        f"urdf/{name}": text,
        **{f"launch/a.launch.{ending}": text for ending, text in launch.items()},
    }
    return Example(bad=files, good={}, on="ament_cmake")


def shown(text: str, name: str, program: str = "robot_state_publisher") -> Example:
    return robot(text, name, xml=SHOW.format(name, program, program))


WORLD = '<sdf version="1.8"><world name="w">{}</world></sdf>\n'
PLUGIN = '<plugin name="a" filename="/home/ada/ws/install/arm/lib/libarm.so"/>'
FETCHED = "<include><uri>file:///home/ada/.gz/fuel/fuel.gazebosim.org/openrobotics/models/shelf/4</uri></include>"
CASES = {
    "URD001": (
        shown(HEAD + JOINT, "robot.urdf.xacro"),
        shown('<robot name="robot">\n' + JOINT, "robot.urdf"),
        *(robot(TEMPLATE, "robot.urdf", py=FILLS.format(how)) for how in (READ, EXPANDED)),
    ),
    "URD002": (
        *(shown(WORLD.format(each), "robot.sdf", "ros_gz_sim") for each in (PLUGIN, FETCHED)),
        shown(HEAD + INCLUDES, "robot.urdf.xacro"),
        shown(HEAD + GAZEBO, "robot.urdf.xacro"),
        shown(HEAD + GAZEBO, "robot.urdf.xacro", "ros_gz_sim_gazebo"),
    ),
}

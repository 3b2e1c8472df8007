"""Lists and words of launch files, types in YAML, and robots by what opens them."""

from __future__ import annotations

from rospkg_cli.example import Example, manifest

from .told_repairs_of_python import told
from .uncalled_values import node, python

LISTED = """\
import os

from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, OpaqueFunction
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node
from my_pkg.launching import Robot


def start(context, config, port, device):
    texts = [context.perform_substitution(each) for each in (config, port, device)]
    return [Node(package='my_pkg', executable='talker', parameters=texts[:1], arguments=texts[1:])]


def generate_launch_description():
    config = os.path.join(get_package_share_directory('my_pkg'), 'config', 'robot.yaml')
    port = LaunchConfiguration('port')
    return LaunchDescription([
        DeclareLaunchArgument('port', default_value='can0', choices=[config, 'can1']),
        __ACTION__,
    ])
"""
LISTS = (
    "OpaqueFunction(function=start, args=[config, port, 'ttyS0'])",
    "OpaqueFunction(function=start, args=[config + 'x', port, 'ttyS0'])",
    "Robot(files=[config, port, 'ttyS0'])",
    "Robot(file=[get_package_share_directory('my_pkg'), '/config/robt.yaml'])",
    "Node(package='my_pkg', executable='talker', name=[config, 'x'])",
)


def typed(interface: str) -> Example:
    """Parameters of a joy_teleop that package.xml lacks too."""
    needs = manifest("  <exec_depend>launch_xml</exec_depend>\n")
    return Example(bad={**told(interface).bad, "package.xml": needs}, good={})


WORDS = python(
    *node("arguments=['-z' '6.35', '-y' '-0.6', '-x' 'arm', '-Y' '1', '-R' '.5']", "arguments=['-ab' 'c', '-t' '/b']"),
    *node("ros_arguments=['-r' 'a:=b', '-p' 'rate:=2.0']"),
    "Node(package='ros_gz_sim', executable='create', arguments=['-z' '6.35', '-topic' 'x'])",
)

CASES = {
    "LCH014": (WORDS,),
    "DEP106": tuple(typed(name) for name in ("geometry_msgs/msg/Twist", "nav2_msgs/action/Spin")),
    "LCH003": tuple(
        Example(
            bad={
                "package.xml": manifest("  <exec_depend>ros2launch</exec_depend>\n"),
                "launch/a.launch.py": LISTED.replace("__ACTION__", action),
                "config/robot.yaml": "/**:\n  ros__parameters:\n    rate: 2.0\n",
            },
            good={},
        )
        for action in LISTS
    ),
}

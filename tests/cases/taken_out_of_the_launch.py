"""Files that only an action opens which a launch file makes and never adds: nothing opens them today."""

from __future__ import annotations

from rospkg_cli.example import CMAKE, Example, manifest

NEEDED = ("ament_index_python", "launch", "launch_ros", "robot_state_publisher", "ros2launch", "turtlesim", "xacro")
LAUNCH = """\
import os

from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch.substitutions import Command
from launch_ros.actions import Node


def generate_launch_description():
    share = get_package_share_directory('my_pkg')
    config = os.path.join(share, 'config', 'sim.yaml')
    sim = Node(package='turtlesim', executable='turtlesim_node', name='sim', parameters=[config])
    robot = os.path.join(share, 'urdf', 'robot.urdf.xacro')
    shown = Node(
        package='robot_state_publisher',
        executable='robot_state_publisher',
        parameters=[{'robot_description': Command(['xacro ', robot])}],
    )
    return LaunchDescription([ACTIONS])
"""
OTHER = "Node(package='turtlesim', executable='mimic', name='sim')"
WITHOUT_KEY = "sim:\n  ros_parameters:\n    background_r: 0\n    background_r: 1\n"
SOME_LINK = """\
<robot xmlns:xacro="http://www.ros.org/wiki/xacro" name="robot">
  <xacro:include filename="wheel.xacro"/>
  <link name="base_link"/>
</robot>
"""


IN_PARTS = "'s' + 'im.yaml'"
WITH_KEY = WITHOUT_KEY.replace("ros_p", "ros__p")


def adding(actions: str, name: str = "'sim.yaml'", values: str = WITHOUT_KEY) -> Example:
    needed = "".join(f"  <exec_depend>{each}</exec_depend>\n" for each in NEEDED)
    installed = "install(DIRECTORY config launch urdf DESTINATION share/${PROJECT_NAME})\nament_package"
    return Example(
        bad={
            "CMakeLists.txt": CMAKE.replace("ament_package", installed),
            "package.xml": manifest(needed, "ament_cmake"),
            "config/sim.yaml": values,
            "urdf/robot.urdf.xacro": SOME_LINK,
            "launch/robot.launch.py": LAUNCH.replace("ACTIONS", actions).replace("'sim.yaml'", name),
        },
        good={},
        on="ament_cmake",
    )


CASES = {
    "PRM001": (adding("sim, shown"), adding("shown"), adding(f"shown, {OTHER}")),
    "PRM002": (
        *(adding(actions, IN_PARTS, WITH_KEY) for actions in ("sim, shown", "shown")),
        adding("sim, shown", IN_PARTS),
    ),
    "URD002": (adding("sim, shown"), adding("sim")),
}

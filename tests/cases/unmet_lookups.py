"""Faults behind the place where a launch looks for a package that nothing brings."""

from __future__ import annotations

from rospkg_cli.example import Example
from rospkg_cli.rules.launch import lch008_undeclared_launch_argument as lch008
from rospkg_cli.rules.launch import lch016_late_argument as lch016

LACKS = '<launch>\n  <arg name="share" default="$(find-pkg-share farm_description)"/>\n'
ROBOT = """\
from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    share = get_package_share_directory('farm_description')
    return LaunchDescription([Node(package='robot_state_publisher', executable='robot_state_publisher')])
"""


def behind(text: str, look: str) -> str:
    return text.replace("«", "").replace("»", "").replace("<launch>\n", look)


CASES = {
    "LCH008": (Example(bad={"launch/a.launch.xml": behind(lch008.BAD, LACKS)}, good={}),),
    "LCH016": (Example(bad={"launch/a.launch.xml": behind(lch016.BAD, LACKS)}, good={}),),
    "PRM008": (Example(bad={"launch/a.launch.py": ROBOT}, good={}),),
}

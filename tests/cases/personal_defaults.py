"""Paths in a home folder that are the default of an argument or a parameter: what is advised."""

from __future__ import annotations

from rospkg_cli.example import SETUP_PY_FOR_ALL, Example, scripts, setup_py

OUT = "/home/ada/ws/src/my_pkg/out"
LAUNCH = f"""\
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument


def generate_launch_description():
    return LaunchDescription([
        DeclareLaunchArgument('out', default_value='{OUT}'),
    ])
"""
NODE = """\
from rclpy.node import Node


class Talker(Node):
    def __init__(self):
        super().__init__('talker')
        self.declare_parameter('out', '{}')
        print(self.get_parameter('out').value)


def main():
    Talker()
"""
XML = f'<launch>\n  <arg name="out" default="{OUT}"/>\n</launch>\n'
STARTS = setup_py(scripts("talker = my_pkg.talker:main"))

CASES = {
    "DEP118": (
        Example(bad={"setup.py": SETUP_PY_FOR_ALL, "launch/a.launch.py": LAUNCH}, good={}),
        Example(bad={"setup.py": SETUP_PY_FOR_ALL, "launch/a.launch.xml": XML}, good={}),
        Example(bad={"setup.py": STARTS, "my_pkg/talker.py": NODE.format(OUT)}, good={}),
        Example(bad={"setup.py": STARTS, "my_pkg/talker.py": NODE.format("/home/ada/out")}, good={}),
    ),
}

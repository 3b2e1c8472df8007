"""Paths in a home folder in texts that are only shown to people, and beside them (DEP118)."""

from __future__ import annotations

from rospkg_cli.example import CMAKE

from .setups import python

HOME = "/home/ada/ws/src/my_pkg/data/people.txt"
FILES = {"data/people.txt": "Ada\n"}
LAUNCH = f"""\
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, LogInfo


def generate_launch_description():
    return LaunchDescription([
        DeclareLaunchArgument('a', {{}}='{HOME}'),
        LogInfo(msg='{HOME}'),
    ])
"""
NODE = f"""\
import argparse

from rcl_interfaces.msg import ParameterDescriptor
from rclpy.node import Node


def main():
    parser = argparse.ArgumentParser(description='{HOME}', epilog='{HOME}')
    parser.add_argument('--people', help='{HOME}', metavar='{HOME}'{{}})
    node = Node('a')
    described = ParameterDescriptor(description='{HOME}')
    described.additional_constraints = '{HOME}'
    node.declare_parameter('a', '', described)
    node.get_logger().info('{HOME}')
"""
XML = f'<launch>\n  <arg name="a" {{}}description="{HOME}"/>\n  <log message="{HOME}"/>\n</launch>\n'
YAML = f"launch:\n  - arg:\n      name: a\n      description: {HOME}\n      default: {{}}\n"
CPP = f"""\
void say() {{{{
  RCLCPP_INFO(logger, "%s", "{HOME}");
  std::cout << "{HOME}" << std::endl;
  descriptor.description = "{HOME}";
  {{}};
}}}}
"""

CASES = {
    "DEP118": tuple(
        python({**FILES, name: text.format(*values)})
        for name, text, given in (
            ("launch/a.launch.py", LAUNCH, (("description",), ("default_value",))),
            ("my_pkg/talker.py", NODE, (("",), (f", default='{HOME}'",))),
            ("launch/a.launch.xml", XML, (("",), (f'default="{HOME}" ',))),
            ("launch/a.launch.yaml", YAML, (("a",), (HOME,))),
            ("src/a.cpp", CPP, (("return",), (f'open("{HOME}")',))),
            ("CMakeLists.txt", f"{CMAKE}message(STATUS {HOME})\n{{}}\n".replace("${", "${{").replace("AME}", "AME}}"),
             (("",), (f"set(A {HOME})",))),
        )
        for values in given
    )
}  # fmt: skip

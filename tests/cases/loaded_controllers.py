"""Removed words of `ros2 control` beside what loads the same controller all the same (LCH005)."""

from __future__ import annotations

from rospkg_cli.example import Example

from .shown_launch_calls import NEEDED

LAUNCH = """\
from launch import LaunchDescription
from launch.actions import ExecuteProcess
from launch.conditions import IfCondition
from launch_ros.actions import Node


def generate_launch_description():
    old = ExecuteProcess(cmd=['ros2', 'control', {}])
    other = {}
    return LaunchDescription([old, other])
"""
OLD, START, CONFIGURE = (
    "'load_start_controller', 'arm'",
    "'load_controller', 'arm', '--set-state', 'start'",
    "'load_configure_controller', 'arm', '-c', '/controller_manager'",
)
SPAWNER = "Node(package='controller_manager', executable='spawner', {})"
ARM = SPAWNER.format("arguments=['arm', '--controller-manager', '/controller_manager']")


def launched(old: str, other: str) -> Example:
    files = {"package.xml": NEEDED, "launch/a.launch.py": LAUNCH.format(old, other), "README.md": "For Jazzy.\n"}
    return Example(bad=files, good={})


CASES = {
    "LCH005": (
        *(launched(each, ARM) for each in (OLD, START, CONFIGURE)),
        *(
            launched(OLD, each)
            for each in (
                SPAWNER.format("arguments=['leg', 'arm']"),
                SPAWNER.format("arguments=['arm', '--inactive']"),
                SPAWNER.format("arguments=['arm', '-c', '/left/controller_manager']"),
                SPAWNER.format("arguments=['leg', '--param-file', 'arm']"),
                SPAWNER.format("arguments=['arm'], condition=IfCondition('false')"),
                "ExecuteProcess(cmd=['ros2 run controller_manager spawner arm'], shell=True)",
                "ExecuteProcess(cmd=['ros2', 'control', 'load_controller', '--set-state', 'active', 'arm'])",
                "ExecuteProcess(cmd=['ros2', 'control', 'load_controller', '--set-state', 'start', 'arm'])",
                "ExecuteProcess(cmd=['ros2', 'control', 'load_controller', 'arm'])",
            )
        ),
        launched(CONFIGURE, SPAWNER.format("arguments=['arm', '--inactive']")),
        launched(CONFIGURE, SPAWNER.format("arguments=['arm', '--load-only']")),
    )
}

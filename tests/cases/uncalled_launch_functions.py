"""Launch files with functions that nothing calls, branches that are never taken, and helpers that make actions."""

from __future__ import annotations

from rospkg_cli.example import Example, manifest

HEAD = """\
import os
from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch.actions import LogInfo
from launch_ros.actions import Node

OLD = False


def make(executable):
    return Node(package='my_pkg', executable=executable)


def more():
    path = os.path.join(get_package_share_directory('my_pkg'), 'config', 'gone.yaml')
    return [
        Node(package='my_pkg', executable='taker', parameters=[path]),
        Node(package='my_pkg', node_executable='talker'),
        Node(package='my_pkg', executable='talker', nam='a'),
        open(os.path.join(get_package_share_directory('my_pkg'), '/config/gone.yaml')),
    ]


def generate_launch_description():
    description = LaunchDescription()
{}
    return description
"""


def launched(*lines: str) -> Example:
    text = HEAD.format("\n".join(f"    {line}" for line in lines))
    needs = ("ament_index_python", "launch", "launch_ros", "ros2launch")
    depends = "".join(f"  <exec_depend>{each}</exec_depend>\n" for each in needs)
    return Example(bad={"package.xml": manifest(depends), "launch/a.launch.py": text}, good={})


UNCALLED = launched("description.add_action(LogInfo(msg='up'))")
CALLED = launched("for each in more():", "    description.add_action(each)")
BY_NAME = launched("for each in globals()['more']():", "    description.add_action(each)")
NEVER = launched("node = make('taker')", "if OLD:", "    description.add_action(node)")
PERHAPS = launched("node = make('taker')", "if os.environ.get('OLD'):", "    description.add_action(node)")
MADE = launched("unused = [make('taker')]", "description.add_action(make('talker'))")

CASES = {
    "LCH002": (UNCALLED, CALLED, BY_NAME, NEVER, PERHAPS, MADE),
    "LCH003": (UNCALLED, CALLED),
    "LCH005": (UNCALLED, CALLED),
    "LCH014": (UNCALLED, CALLED),
    "LCH021": (UNCALLED, CALLED),
}

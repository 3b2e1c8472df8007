"""Packages of launch files in parts that no launch comes to."""

from __future__ import annotations

from rospkg_cli.example import SETUP_PY_FOR_ALL, Example, manifest

NEEDS = manifest("  <exec_depend>ros2launch</exec_depend>\n")
START = "from launch import LaunchDescription\nfrom launch_ros.actions import Node\n\n\n"
JOY = "def joy():\n    return Node(package='joy', executable='joy_node')\n\n\n"
ENTRY = "def generate_launch_description():\n    return LaunchDescription([{}])\n"
IMPORTS = f"from nodes import joy\n{START}{ENTRY.format('joy()')}"
XML = '<launch>\n  <node pkg="joy" exec="joy_node" {}/>\n</launch>\n'


def launched(**files: str) -> Example:
    named = {f"launch/{name.replace('_DOT_', '.')}": text for name, text in files.items()}
    return Example(bad={"package.xml": NEEDS, "setup.py": SETUP_PY_FOR_ALL, **named}, good={})


CASES = {
    "DEP103": (
        launched(a_DOT_launch_DOT_py=START + JOY + ENTRY.format("")),
        launched(a_DOT_launch_DOT_py=START + JOY + ENTRY.format("joy()")),
        launched(nodes_DOT_py=START + JOY),
        launched(nodes_DOT_py=START + JOY, a_DOT_launch_DOT_py=IMPORTS),
        launched(a_DOT_launch_DOT_xml=XML.format('if="false"')),
        launched(a_DOT_launch_DOT_xml=XML.format('unless="True"')),
        launched(a_DOT_launch_DOT_xml=XML.format('if="true"')),
        launched(
            a_DOT_launch_DOT_py=START + JOY + ENTRY.format(""),
            b_DOT_launch_DOT_xml=XML.format(""),
        ),
    ),
}

"""LCH005 removed-launch-argument."""

from __future__ import annotations

from collections.abc import Iterator

from ...example import SETUP_PY_FOR_ALL, Example, manifest
from ...finding import Edit, Fix, Hit, Safety, Severity
from ...package.launch.file import LaunchFile
from ...rule import rule

PYTHON = """\
from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription([Node(package='my_pkg', «node_executable»='talker', name='talker')])
"""
XML = """\
<launch>
  <let name="topic" value="chatter"/>
  <node pkg="my_pkg" «type»="talker" args="$(var topic)"/>
</launch>
"""
FILES = {
    "package.xml": manifest("  <exec_depend>ros2launch</exec_depend>\n"),
    "setup.py": SETUP_PY_FOR_ALL.replace(
        "    license=", "    entry_points={'console_scripts': ['talker = my_pkg.talker:main']},\n    license="
    ),
    "my_pkg/talker.py": "def main():\n    pass\n",
}


@rule(
    "LCH005",
    "removed-launch-argument",
    over=LaunchFile,
    severity=Severity.ERROR,
    examples=(
        Example(
            bad={**FILES, "launch/talker.launch.py": PYTHON},
            good={"launch/talker.launch.py": PYTHON.replace("«node_executable»", "executable")},
            fix=Safety.SAFE,
        ),
        Example(
            bad={**FILES, "launch/talker.launch.xml": XML},
            good={"launch/talker.launch.xml": XML.replace("«type»", "exec")},
            fix=Safety.SAFE,
        ),
    ),
)
def removed_launch_argument(file: LaunchFile) -> Iterator[Hit]:
    """
    ## What it does
    Finds arguments of nodes that launch_ros removed, such as `node_executable`.
    They are `node_executable`, `node_name`, `node_namespace` and `node_plugin`, which launch_ros had up to Foxy, and
    `type=` of XML nodes, which is ROS 1's. Files that check which distro they run on are left alone.

    ## Why is this bad?
    The launch stops with "__init__() got an unexpected keyword argument 'node_executable'" or "missing 1 required
    keyword-only argument: 'executable'".
    """
    for each in file.removed:
        other = f", and `{each.now}` is given as well: take it out" if each.twice else f"; it is `{each.now}` now"
        message = f"launch no longer takes `{each.name}` of a node and stops there{other}"
        edit = Edit(file.path, each.span, each.now)
        fix = None if each.twice else Fix(f"call it `{each.now}`", (edit,))
        yield Hit(file.path, each.span, message, fix=fix)

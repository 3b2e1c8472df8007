"""LCH005 removed-launch-argument."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.fault import Fault, Level, softer_advice
from ...checks.launch.call_errors import LaunchCalls
from ...checks.launch.idle_actions import IN_BRANCH, NO_ENTRY, level_at
from ...checks.launch.removed_arguments import removed_arguments
from ...checks.launch.removed_commands import removed_commands
from ...edits.fault_hits import hits
from ...example import SETUP_PY_FOR_ALL, Example, manifest
from ...finding import Hit, Safety, Severity
from ...light_dataclasses import replace
from ...rule import rule

LATER = "launch no longer takes"
"""What Foxy takes; the rest is ROS 1's."""
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
    over=LaunchCalls,
    severity=Severity.ERROR,
    levels={
        Severity.WARNING: "its condition is false by default, or it stands in a branch that is not always taken",
        Severity.INFO: "the action is never added to the launch description, something else here loads the controller, "
        "or the repository is for Foxy",
    },
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
def removed_launch_argument(calls: LaunchCalls) -> Iterator[Hit]:
    """
    ## What it does
    Finds arguments of nodes that launch_ros removed, such as `node_executable`.
    They are `node_executable`, `node_name`, `node_namespace` and `node_plugin`, which launch_ros had up to Foxy, and
    `type=` of nodes, which is ROS 1's. States and verbs that `ros2 control` no longer has are told, too
    (`load_controller --set-state start`).

    ## Why is this bad?
    The launch stops with `__init__() got an unexpected keyword argument 'node_executable'` or `missing 1 required
    keyword-only argument: 'executable'`.

    ## When it is quiet
    Files that check which distribution they run on are left alone, and so are launch files for ROS 1. Where pages and
    scripts of the repository (or, if these name none, its other pages, launch files, docstrings and names of files)
    name Foxy and no later distribution, or a folder is called after it, it is an info; so is
    a word of `ros2 control` where they name Foxy or Galactic alone, or where a spawner or another command of the launch
    file brings the same controller into the state. A Python file whose name or folder says that it is for Foxy or an
    older one (`launch/foxy/`, `eloquent_start.py`), beside launch files for others, is left alone.
    """
    if calls.file.frontend == "python" and calls.distribution.is_kept_for_older(calls.file.path):
        return
    file, distribution = calls.file, calls.distribution
    keywords, commands = list(removed_arguments(file)), list(removed_commands(file))
    if file.frontend == "python" and distribution.is_for_older(file.path):
        keywords = [
            softer_advice(each, "info", "but not in Foxy") if each.message.startswith(LATER) else each
            for each in keywords
        ]
    if distribution.is_for_unsupported(file.path):
        commands = [softer_advice(each, "info", "but not in Foxy and Galactic") for each in commands]
    for fault in keywords:
        level, why = level_at(file, fault.span)
        if why in (NO_ENTRY, IN_BRANCH):  # a condition of launch does not help: Python refuses to make the action
            fault = softer_advice(fault, milder(fault, "warning"), why)
        yield from hits(file.path, [replace(fault, level="info") if level == "info" else fault])
    for fault in commands:
        level, why = level_at(file, fault.span)
        yield from hits(file.path, [softer_advice(fault, milder(fault, level), why) if level else fault])


def milder(fault: Fault, level: Level) -> Level:
    return "info" if fault.level == "info" else level

"""LCH005 removed-launch-argument."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.fault import Fault
from ...checks.launch.one_cause import CausedPlace
from ...checks.launch.removed_words import RemovedWord, RemovedWords
from ...edits.caused_places import other_places
from ...edits.fault_hits import fix_for
from ...example import SETUP_PY_FOR_ALL, Example, manifest
from ...finding import Fix, Hit, Related, Safety, Severity
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
    over=RemovedWords,
    severity=Severity.ERROR,
    levels={
        Severity.WARNING: "its condition is not known, or it stands in a branch that is not always taken",
        Severity.INFO: "the action is off by default or never added to the launch description, something else here "
        "loads the controller, or nothing shows that the repository is for later distributions than those that had it",
    },
    examples=(
        Example(
            bad={**FILES, "launch/talker.launch.py": PYTHON, "README.md": "For ROS 2 Jazzy.\n"},
            good={"launch/talker.launch.py": PYTHON.replace("«node_executable»", "executable")},
            fix=Safety.SAFE,
        ),
        Example(
            bad={**FILES, "launch/talker.launch.xml": XML, "README.md": "ros2 launch my_pkg talker.launch.xml\n"},
            good={"launch/talker.launch.xml": XML.replace("«type»", "exec")},
            fix=Safety.SAFE,
        ),
    ),
)
def removed_launch_argument(words: RemovedWords) -> Iterator[Hit]:
    """
    ## What it does
    Finds arguments of nodes that launch_ros removed, such as `node_executable`.
    They are `node_executable`, `node_name`, `node_namespace` and `node_plugin`, which launch_ros had up to Foxy, and
    `type=` of nodes, which is ROS 1's. States and verbs that `ros2 control` no longer has are reported as well
    (`load_controller --set-state start`). What is alike in the launch files of a package is one finding, where it is
    worst.

    ## Why is this bad?
    The launch stops with `__init__() got an unexpected keyword argument 'node_executable'` or `missing 1 required
    keyword-only argument: 'executable'`.

    ## When it is quiet
    Left alone are launch files for ROS 1, files that check which distribution they run on, and Python files whose name
    or folder says that they are for Foxy or an older one (`launch/foxy/`, `eloquent_start.py`), next to launch files
    for others.

    It is an error only where the run checks for a distribution (`--target`), or where pages, scripts and workflows of
    the repository name Humble or later ones alone; if these name none, its other pages, launch files, docstrings and
    names of files decide. Otherwise it is an info. The same holds for words of `ros2 control`. It is always an info in
    a folder that is named after Foxy, and where a spawner or another command of the launch file brings the same
    controller into the state.
    """
    for fault, places in words.together():
        first, again = places[0], other_places(places)
        around = [Related(each.path, *place) for each in places for place in each.item.fault.related]
        level = Severity(fault.level) if fault.level else None
        yield Hit(
            first.path, first.span, fault.message, level, tuple(dict.fromkeys((*again, *around))), rename(fault, places)
        )


def rename(fault: Fault, places: list[CausedPlace[RemovedWord]]) -> Fix | None:
    """Return what renames all of them; None where one of them can't be."""
    repairs = [each.item.fault.repair for each in places]
    if fault.repair is None or not all(repairs):
        return None
    fixes = [fix_for(each.path, repair) for each, repair in zip(places, repairs, strict=True) if repair]
    unsafe = any(each.safety is Safety.UNSAFE for each in fixes)
    edits = dict.fromkeys(edit for each in fixes for edit in each.operations)
    return Fix(fault.repair.title, tuple(edits), Safety.UNSAFE if unsafe else Safety.SAFE)

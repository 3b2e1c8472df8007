"""LCH021 dropped-path."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.dropped_paths import DroppedPaths
from ...example import Example, manifest
from ...finding import Hit, Severity
from ...rule import rule

NEEDED = """\
  <exec_depend>ament_index_python</exec_depend>
  <exec_depend>launch_ros</exec_depend>
  <exec_depend>ros2launch</exec_depend>
  <exec_depend>rviz2</exec_depend>
"""
BAD = """\
import os

from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    config = os.path.join(get_package_share_directory('my_pkg'), 'config', «'/robot.rviz'»)
    return LaunchDescription([Node(package='rviz2', executable='rviz2', arguments=['-d', config])])
"""


@rule(
    "LCH021",
    "dropped-path",
    over=DroppedPaths,
    severity=Severity.WARNING,
    levels={
        Severity.INFO: "it is a path that many machines have (`/tmp/…`), no file or folder fits the rest, nothing "
        "installs the file, no program is shown to come there, or a launch file does not use what is made of the path"
    },
    examples=(
        Example(
            bad={"package.xml": manifest(NEEDED), "launch/a.launch.py": BAD, "config/robot.rviz": ""},
            good={"launch/a.launch.py": BAD.replace("«'/", "'").replace("»", "")},
        ),
    ),
)
def dropped_path(paths: DroppedPaths) -> Iterator[Hit]:
    """
    ## What it does
    Finds paths that are joined to a part with a slash at its beginning.
    It looks at `os.path.join`, `PathJoinSubstitution`, and `/`, `joinpath` and `Path(…)` of pathlib, in launch files
    and in other Python code.

    ## Why is this bad?
    Such a part is a path from the root: what stands before it is dropped without a word, and
    `os.path.join(share, '/config/robot.yaml')` is `/config/robot.yaml`, which no machine has.

    ## When it is quiet
    Left alone are paths that begin with what stands before them, and parts that are unpacked with `*`. Where setup.py
    installs something, SET208 reports it. In a launch file it is an info where nothing adds the action that the path is
    for, or reads the local variable or the argument. In other code it is one where no program is shown to run the line,
    and where the path may be the name of a topic (`os.path.join(namespace, '/cmd_vel')`).
    """
    for each in paths.all:
        how = "`/`" if each.by == "/" else f"`{each.by}`"
        dropped = each.dropped if len(each.dropped) <= 60 and "\n" not in each.dropped else "what stands before it"
        shown = dropped if dropped.startswith("what") else f"`{dropped}`"
        text = f"`{each.text}` begins with a slash: {how} drops {shown}, and the path begins at the root"
        unused = ", but nothing uses it" if each.is_unused else ""
        mild = (
            unused
            or each.why_unmet
            or each.is_of_system
            or not each.is_of_files
            or (each.role in ("aside", "test") and each.file.path != "setup.py")
        )
        better = each.text.lstrip("/")
        hint = f"write `{better}`" if better and not each.is_of_system else "remove what stands before it, or the slash"
        yield Hit(each.file.path, each.span, f"{text}{unused}; {hint}{each.why_unmet}", Severity.INFO if mild else None)

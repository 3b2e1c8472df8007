"""LCH019 unknown-bridge-type."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.launch.bridge_arguments import bridge_faults
from ...checks.launch.missing_references import LaunchContext
from ...edits.fault_hits import hits
from ...example import Example, manifest
from ...finding import Hit, Severity
from ...rule import rule

BAD = """\
<launch>
  <node pkg="ros_gz_bridge" exec="parameter_bridge" args="/clock@«rosgraph_msg»/msg/Clock[gz.msgs.Clock"/>
</launch>
"""
NEEDED = "  <exec_depend>ros2launch</exec_depend>\n  <exec_depend>ros_gz_bridge</exec_depend>\n"


@rule(
    "LCH019",
    "unknown-bridge-type",
    over=LaunchContext,
    severity=Severity.WARNING,
    examples=(
        Example(
            bad={"package.xml": manifest(NEEDED), "launch/a.launch.xml": BAD},
            good={"launch/a.launch.xml": BAD.replace("«rosgraph_msg»", "rosgraph_msgs")},
        ),
    ),
)
def unknown_bridge_type(scope: LaunchContext) -> Iterator[Hit]:
    """
    ## What it does
    Finds misspelt types in the arguments of `parameter_bridge` of ros_gz_bridge.
    An argument is `topic@package/msg/Type`, and what stands for Gazebo behind `@`, `[` or `]`.

    ## Why is this bad?
    The bridge says that it knows no such pair of types, and goes on without the topic.

    ## When it is quiet
    A package that may exist is believed, and so is a type of it that is near none of its known ones.
    """
    yield from hits(scope.file.path, bridge_faults(scope))

"""PRM004 unsupported-yaml."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.params.rcl_validation import rcl_faults
from ...checks.params.rcl_values import EMPTY_LIST
from ...checks.params.refused_values import RefusedValues
from ...edits.fault_hits import hits
from ...example import Example, manifest
from ...finding import Hit, Severity
from ...light_dataclasses import replace
from ...rule import rule

GOOD = """\
talker:
  ros__parameters:
    rate: 10.0
"""


HANDED = {
    "package.xml": manifest("  <exec_depend>turtlesim</exec_depend>\n", "ament_cmake"),
    "config/start.launch.xml": """\
<launch>
  <node pkg="turtlesim" exec="turtlesim_node">
    <param from="$(find-pkg-share my_pkg)/config/robot.yaml"/>
  </node>
</launch>
""",
}
"""A launch file that gives the file to a node."""


def example(bad: str, good: str) -> Example:
    files = {**HANDED, "config/robot.yaml": GOOD + bad}
    return Example(on="config", bad=files, good={"config/robot.yaml": GOOD + good})


@rule(
    "PRM004",
    "unsupported-yaml",
    over=RefusedValues,
    severity=Severity.ERROR,
    levels={
        Severity.WARNING: "a list is empty, at which only C++ nodes stop, rcl reads past the mappings in a list, or "
        "launch files, code or a page name the file, and none is shown to give it to a node",
        Severity.INFO: "nothing names the file, the nodes that get it are never started, components alone do, or a "
        "list is empty in a block that no C++ node is shown to read",
    },
    examples=(
        example("    limits: [1, «2.5»]\n", "    limits: [1.0, 2.5]\n"),
        example("    names: «[]»\n", "    names: ['']\n"),
        example("    frame: &frame map\n    other: «*frame»\n", "    frame: map\n    other: map\n"),
        example("    «frame»:\n    other: map\n", "    other: map\n"),
        example("    points: [«[0.0, 1.0]», [2.0, 3.0]]\n", "    points: [0.0, 1.0, 2.0, 3.0]\n"),
        example("«my-node»:\n  ros__parameters:\n    a: 1\n", "my_node:\n  ros__parameters:\n    a: 1\n"),
        example("«version»: 2\n", ""),
    ),
)
def unsupported_yaml(scope: RefusedValues) -> Iterator[Hit]:
    """
    ## What it does
    Finds valid YAML in a parameter file that rcl does not accept.
    It is aliases, lists that mix types, empty lists (their type is unknown), lists of several lists, or of mappings
    with several keys, values that are missing or above `ros__parameters:`, names that no node can have. In a list `1`
    and `2.5` are of two types, and `y` is a bool.

    ## Why is this bad?
    rcl refuses the whole file, and every node that is given it stops when it starts, often with a message about
    something else. At an empty list a C++ node throws "No parameter value set".

    ## When it is quiet
    Left alone are

    - files without `ros__parameters` that no launch file passes to a node, which may hold any YAML;
    - files that only code names and parses, or that a launch file parses itself, to hand on values; and what a
      `RewrittenYaml`, as nav2_bringup has one for its `params_file`, fills in, or an alias of plain values that it
      writes out;
    - lists of mappings with one key each (`- a: 1`), of which rcl makes parameters;
    - empty lists that launch files give only to nodes in Python (of a Python package, or an executable `*.py`).

    It is a warning

    - for other mappings in a list where all that stands in them is of one type, as keys and quoted numbers are (`-
      name: a`, `type: b`): rcl reads past them, the node starts, and the list is not set;
    - for an empty list, which a Python node takes;
    - for all of a file that no launch file of the workspace gives a node by its path.

    It is an info

    - for an empty list in a block that no C++ node is shown to read: one that is started, is given the file or has the
      block's name, and is of a package that is here or released;
    - for all but empty lists where launch files give the file to components alone, which get it as PyYAML reads it;
    - where no launch file, program or README of the workspace names the file, or only nodes get it that are never
      started (their launch file is not installed, or their action never added).

    ## References
    ros2/rcl: rcl_yaml_param_parser/src/parse.c; ros2/rclcpp: parameter_map.cpp
    """
    use, file = scope.use, scope.use.file
    if use.is_parsed_by_launch:
        return
    seen: set[tuple[int, str]] = set()  # `{0.0, 0.0}` lacks two values for one reason
    for fault in rcl_faults(file):
        is_empty = fault.message.startswith(EMPTY_LIST)
        if use.is_rewritten(fault.span) or scope.is_resolved(fault) or (is_empty and use.is_for_python):
            continue
        place = file.source.position(fault.span.start)[0], fault.message
        if place not in seen:
            seen.add(place)
            found = scope.at_its_level(fault) if is_empty else fault
            level = scope.level if is_empty else scope.level_in_rcl
            is_info = "info" in (found.level, level)
            yield from hits(file.path, [replace(found, level="info" if is_info else found.level or level)])

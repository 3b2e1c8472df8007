"""PRM001 missing-ros-parameters."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.params.refused_values import RefusedValues
from ...checks.params.ros_parameters_key import key_faults
from ...edits.fault_hits import hits
from ...example import Example, manifest
from ...finding import Hit, Safety, Severity
from ...light_dataclasses import replace
from ...rule import rule

GOOD = """\
talker:
  ros__parameters:
    rate: 10.0
listener:
  ros__parameters:
    depth: 5
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


@rule(
    "PRM001",
    "missing-ros-parameters",
    over=RefusedValues,
    severity=Severity.ERROR,
    levels={
        Severity.WARNING: "launch files, code or a page name the file, and none is shown to give it to a node",
        Severity.INFO: "nothing names the file, the nodes that get it are never started, or code parses it itself",
    },
    examples=(
        Example(
            on="config",
            bad={**HANDED, "config/robot.yaml": GOOD.replace("ros__parameters", "«ros_parameters»", 1)},
            good={"config/robot.yaml": GOOD},
            fix=Safety.SAFE,
        ),
        Example(
            on="config",
            bad={**HANDED, "config/robot.yaml": GOOD.replace("listener:\n  ros__parameters:\n    ", "«listener»:\n  ")},
            good={"config/robot.yaml": GOOD},
            fix=Safety.UNSAFE,
        ),
    ),
)
def missing_ros_parameters(scope: RefusedValues) -> Iterator[Hit]:
    """
    ## What it does
    Finds parameter files with a missing or misspelt `ros__parameters:` below a node.
    It has two `_` in the middle and an `s` at the end.

    ## Why is this bad?
    rcl refuses the whole file: "Cannot have a value before ros__parameters". Every node that is given the file stops
    when it starts.

    ## When it is quiet
    Only YAML files that hold a block of parameters (perhaps misspelt), begin with `/**:`, or are passed to a node by a
    launch file are read; tests and templates are not. Where a launch file parses the file itself (`yaml.safe_load`) and
    gives no node its path, a block without the key may be for something else. Nothing is reported in a file that only
    code opens: launch for single values of it, or a program by a parser of its own.

    It is an error only where a launch file of the workspace gives a node the file by its path. It is an info where
    nothing of the workspace names the file, or only nodes get it that are never started.

    ## Fix safety
    The fix of the spelling is safe. A missing `ros__parameters:` is added above all that the block holds, which is
    wrong if the block is a namespace.

    ## References
    ros2/rcl: rcl_yaml_param_parser/src/parse.c
    """
    use, is_parsed = scope.use, scope.use.is_parsed_by_launch
    level = "info" if is_parsed else scope.level
    for fault in key_faults(use.file, is_parsed_by_launch=is_parsed):
        yield from hits(use.file.path, [replace(fault, level=level)])

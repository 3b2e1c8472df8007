"""PRM002 duplicate-parameter."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.params.repeated_names import ParameterFiles
from ...edits.fault_hits import hits
from ...edits.same_infos import same_infos_once
from ...example import Example
from ...finding import Hit, Severity
from ...rule import rule

GOOD = """\
talker:
  ros__parameters:
    rate: 10.0
    depth: 5
"""


@rule(
    "PRM002",
    "duplicate-parameter",
    over=ParameterFiles,
    severity=Severity.WARNING,
    levels={Severity.INFO: "both hold mappings, which rcl joins, or one value, or no node reads it"},
    examples=(
        Example(
            on="config",
            bad={"config/robot.yaml": GOOD + "    «rate»: 20.0\n"},
            good={"config/robot.yaml": GOOD},
        ),
        Example(
            on="config",
            bad={"config/robot.yaml": GOOD + "«talker»:\n  ros__parameters:\n    verbose: true\n"},
            good={"config/robot.yaml": GOOD + "    verbose: true\n"},
        ),
        Example(
            on="config",
            bad={"config/robot.yaml": GOOD + "    arm.speed: 1.0\n    arm:\n      «speed»: 2.0\n"},
            good={"config/robot.yaml": GOOD + "    arm.speed: 1.0\n"},
        ),
    ),
)
def duplicate_parameter(every: ParameterFiles) -> Iterator[Hit]:
    """
    ## What it does
    Finds duplicate names in one mapping of a parameter file.
    They are parameters, groups of parameters or nodes. `a.b: 1` and `a: {b: 2}` are one name. Infos of one kind are one
    finding a package.

    ## Why is this bad?
    There is no warning. rcl takes the last value and joins blocks; what reads YAML in Python (composable nodes in
    launch files, nav2's RewrittenYaml) keeps only the last block, and all parameters of the first are gone.

    ## When it is quiet
    Names in different blocks, or in different documents of a file, may well be the same. Where both values are written
    alike nothing changes, and it is an info; so it is where nothing opens the file, rcl refuses it as a whole, or no
    node that is started with it reads the block.

    ## References
    ros2/rclcpp#2166
    """
    found = (hit for file in every.files for hit in hits(file.path, every.faults(file)))
    yield from same_infos_once(found, "remove what is there twice")

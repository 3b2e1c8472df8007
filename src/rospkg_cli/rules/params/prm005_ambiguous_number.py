"""PRM005 ambiguous-number."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.params.ambiguous_numbers import number_faults
from ...checks.params.launch_parameters import LaunchParameters
from ...edits.fault_hits import hits
from ...edits.same_infos import same_infos_once
from ...example import Example
from ...finding import Hit, Safety, Severity
from ...package.params.parameter_file import ParameterFile
from ...rule import rule

GOOD = """\
filter:
  ros__parameters:
    noise: 1.0e-9
    period: 10
"""


@rule(
    "PRM005",
    "ambiguous-number",
    over=LaunchParameters,
    severity=Severity.WARNING,
    levels={Severity.INFO: "rcl alone reads the file, and reads the number correctly"},
    examples=(
        Example(
            on="config",
            bad={"config/robot.yaml": GOOD.replace("1.0e-9", "«1e-9»")},
            good={"config/robot.yaml": GOOD},
            fix=Safety.SAFE,
        ),
        Example(
            on="config",
            bad={"config/robot.yaml": GOOD.replace("10", "«010»")},
            good={"config/robot.yaml": GOOD},
        ),
        Example(
            on="config",
            bad={"config/robot.yaml": GOOD.replace("10", "«10_000»")},
            good={"config/robot.yaml": GOOD.replace("10", "10000")},
            fix=Safety.SAFE,
        ),
    ),
)
def ambiguous_number(launched: LaunchParameters) -> Iterator[Hit]:
    """
    ## What it does
    Finds numbers that rcl and YAML 1.1 read differently.
    `1e-9` is a number for rcl and a string for PyYAML, `10_000` the other way round, and `010` is 8 for both. In a list
    only the first of a kind is reported, and of infos the first of a kind in the package.

    ## Why is this bad?
    A node reads its file through rcl. Launch files read the same file through PyYAML when they pass it to a composable
    node or rewrite it: the parameter arrives as a string, and the node stops with an invalid type.

    ## When it is quiet
    Where no launch file reads the file with Python, what rcl reads as a number is an info. Numbers in quotes are
    strings for both, and `03` is 3 for both, as in decimal.

    ## References
    ros2/rcl: rcl_yaml_param_parser/src/parse.c; https://yaml.org/type/float.html
    """
    found = (hit for file in launched.files if launched.is_whole for hit in of_file(launched, file))
    yield from same_infos_once(found, "write the numbers so that both read them")


def of_file(launched: LaunchParameters, file: ParameterFile) -> Iterator[Hit]:
    return hits(file.path, number_faults(file, is_read_by_python=launched.is_read_by_python(file)))

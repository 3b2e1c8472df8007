"""PRM005 ambiguous-number."""

from __future__ import annotations

from collections.abc import Iterator

from ...example import Example
from ...finding import Edit, Fix, Hit, Safety, Severity
from ...model.params.file import ParameterFile
from ...model.params.numbers import ambiguous_numbers
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
    over=ParameterFile,
    severity=Severity.WARNING,
    levels={Severity.INFO: "rcl alone reads the number as it was meant"},
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
def ambiguous_number(file: ParameterFile) -> Iterator[Hit]:
    """
    ## What it does
    Finds numbers that rcl and YAML 1.1 read differently: `1e-9` is a number for rcl and a text for PyYAML, `10_000`
    the other way round, and `010` is 8 for both. In a list the first of a kind stands for all.

    ## Why is this bad?
    A node reads its file through rcl. Launch files read the same file through PyYAML when they pass it to a composable
    node or rewrite it: the parameter arrives as a text, and the node stops with an invalid type.

    ## References
    ros2/rcl: rcl_yaml_param_parser/src/parse.c; https://yaml.org/type/float.html
    """
    for number in ambiguous_numbers(file):
        fix = None
        if number.repairs:
            edits = tuple(Edit(file.path, span, text) for span, text in number.repairs)
            fix = Fix(f"write `{number.repairs[0][1]}`", edits)
        level = Severity.INFO if number.right_for_rcl else None
        yield Hit(file.path, number.span, number.message, level, fix=fix)

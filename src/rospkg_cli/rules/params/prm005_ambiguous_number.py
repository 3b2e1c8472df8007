"""PRM005 ambiguous-number."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.params.ambiguous_numbers import block_faults
from ...checks.params.block_readers import BlockReaders
from ...edits.fault_hits import hits
from ...edits.same_infos import same_infos_once
from ...example import Example
from ...finding import Hit, Safety, Severity
from ...light_dataclasses import replace
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
    over=BlockReaders,
    severity=Severity.WARNING,
    levels={Severity.INFO: "rcl alone reads the block, and reads the number correctly, or no node reads it"},
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
def ambiguous_number(readers: BlockReaders) -> Iterator[Hit]:
    """
    ## What it does
    Finds numbers that rcl and YAML 1.1 read differently.
    `1e-9` is a number for rcl and a string for PyYAML, `10_000` the other way round, and `010` is 8 for both. In a list
    only the first of a kind is reported, and of infos the first of a kind in the package.

    ## Why is this bad?
    A node reads its file through rcl. Launch files read the same file through PyYAML when they pass it to a composable
    node or rewrite it: the parameter arrives as a string, and the node stops with an invalid type.

    ## When it is quiet
    Where no component that is started reads the block with Python, what rcl reads as a number is an info. So is every
    number in a file that nothing opens, or in a block that no node reads which is started with it. Numbers in quotes
    are strings for both, and `03` is 3 for both, as in decimal.

    ## References
    ros2/rcl: rcl_yaml_param_parser/src/parse.c; https://yaml.org/type/float.html
    """
    launched = readers.launched
    found = (hit for file in launched.files if launched.is_whole for hit in of_file(readers, file))
    yield from same_infos_once(found, "write the numbers so that both read them")


def of_file(readers: BlockReaders, file: ParameterFile) -> Iterator[Hit]:
    for block in file.blocks:
        for fault in block_faults(block, is_read_by_python=readers.is_read_by_python(file, block)):
            is_idle = fault.level != "info" and readers.is_idle(file.path, fault.span)
            yield from hits(file.path, [replace(fault, level="info") if is_idle else fault])

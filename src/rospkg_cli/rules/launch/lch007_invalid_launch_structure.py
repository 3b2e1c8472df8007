"""LCH007 invalid-launch-structure."""

from __future__ import annotations

from collections.abc import Iterator

from ...example import Example
from ...finding import Hit, Severity
from ...model.launch.file import LaunchFile
from ...rule import rule

BAD = '<launch>\n  <let name="speed" «valeu»="1.0"/>\n</launch>\n'
BAD_YAML = "launch:\n- arg:\n    name: speed\n    «defalt»: '1.0'\n"
BAD_SUBSTITUTION = '<launch>\n  <arg name="speed"/>\n  <let name="twice" value="«$»(var speed"/>\n</launch>\n'


@rule(
    "LCH007",
    "invalid-launch-structure",
    over=LaunchFile,
    severity=Severity.ERROR,
    examples=(
        Example(
            bad={"launch/a.launch.xml": BAD},
            good={"launch/a.launch.xml": BAD.replace("«valeu»", "value")},
        ),
        Example(
            bad={"launch/a.launch.yaml": BAD_YAML},
            good={"launch/a.launch.yaml": BAD_YAML.replace("«defalt»", "default")},
        ),
        Example(
            bad={"launch/a.launch.xml": BAD_SUBSTITUTION},
            good={"launch/a.launch.xml": BAD_SUBSTITUTION.replace("«$»(var speed", "$(var speed)")},
        ),
    ),
)
def invalid_launch_structure(file: LaunchFile) -> Iterator[Hit]:
    """
    ## What it does
    Finds what launch refuses in an XML or YAML launch file: attributes that an action does not have, attributes that
    are missing, entities that can't stand where they stand, and substitutions that are malformed or take another
    number of arguments. Actions and substitutions that nobody knows are left alone, since packages may add their own,
    unless one letter makes a known one of them.

    ## Why is this bad?
    launch reads the whole file before it starts anything: one such place, and nothing is started.
    """
    for fault in file.faults:
        yield Hit(file.path, fault.span, fault.message)

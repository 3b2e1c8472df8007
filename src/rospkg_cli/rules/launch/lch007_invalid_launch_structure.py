"""LCH007 invalid-launch-structure."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.fault import once_each, softer
from ...checks.launch.entity_schema import entity_faults, with_entity_names
from ...checks.launch.python_expressions import expression_faults
from ...checks.launch.who_meets import LaunchFileAmongPackages, level_met
from ...edits.fault_hits import hits
from ...example import Example, manifest
from ...finding import Hit, Severity
from ...rule import rule

BAD = '<launch>\n  <let name="speed" «valeu»="1.0"/>\n</launch>\n'
BAD_YAML = "launch:\n- arg:\n    name: speed\n    «defalt»: '1.0'\n"
BAD_SUBSTITUTION = '<launch>\n  <arg name="speed"/>\n  <let name="twice" value="«$»(var speed"/>\n</launch>\n'
NEEDED = manifest("  <exec_depend>ros2launch</exec_depend>\n")
BAD_EXPRESSION = """\
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, LogInfo
from launch.conditions import IfCondition
from launch.substitutions import LaunchConfiguration, PythonExpression


def generate_launch_description():
    headless = LaunchConfiguration('headless')
    return LaunchDescription([
        DeclareLaunchArgument('headless', default_value='true'),
        LogInfo(msg='up', condition=IfCondition(«PythonExpression(['not ', headless])»)),
    ])
"""


@rule(
    "LCH007",
    "invalid-launch-structure",
    over=LaunchFileAmongPackages,
    severity=Severity.ERROR,
    levels={
        Severity.WARNING: "the default of an argument makes an expression fail, or its condition is not known",
        Severity.INFO: "the action with the expression is off by default or never added to the launch description",
    },
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
        Example(
            bad={
                "package.xml": manifest("  <exec_depend>ros2launch</exec_depend>\n"),
                "launch/a.launch.py": BAD_EXPRESSION,
            },
            good={"launch/a.launch.py": BAD_EXPRESSION.replace("«", "").replace("»", "").replace("'true'", "'True'")},
        ),
    ),
)
def invalid_launch_structure(scope: LaunchFileAmongPackages) -> Iterator[Hit]:
    """
    ## What it does
    Finds what launch refuses in an XML or YAML launch file, and invalid Python expressions.
    In XML and YAML: unknown or missing attributes, misplaced entities, and substitutions that are malformed or take
    another number of arguments. In every format: Python expressions (`PythonExpression`, `$(eval …)`)
    that are invalid whatever the arguments are, and those with a name that Python does not know: `true` and `false`,
    mostly, from the default of an argument.

    ## Why is this bad?
    launch reads an XML or YAML file as a whole before it starts anything: one error, and nothing is started. An
    expression that Python can't evaluate stops the launch when it is evaluated.

    ## When it is quiet
    Unknown actions and substitutions are left alone, since packages add their own, unless they are one letter from a
    known one. Expressions are evaluated with the defaults of the file's own arguments; where a part is unknown, only an
    expression that no value makes valid is reported.
    """
    file = scope.file
    yield from hits(file.path, with_entity_names(file, once_each(entity_faults(file))))
    for fault in expression_faults(file):
        level, why = level_met(file, fault.span, scope.workspace)
        yield from hits(file.path, [softer(fault, level, why) if level else fault])

"""LCH016 late-argument."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.launch.documented_arguments import DOCUMENTED, ConfigurationsAndPages
from ...checks.launch.unset_configurations import unset
from ...checks.launch.who_meets import why_unvisited
from ...example import Example, manifest
from ...finding import Hit, Severity
from ...rule import rule

BAD = """\
<launch>
  <log message="at $(var «rate») Hz"/>
  <arg name="rate" default="10"/>
</launch>
"""
GOOD = """\
<launch>
  <arg name="rate" default="10"/>
  <log message="at $(var rate) Hz"/>
</launch>
"""


@rule(
    "LCH016",
    "late-argument",
    over=ConfigurationsAndPages,
    severity=Severity.WARNING,
    levels={
        Severity.INFO: "the launch ends before, at a package that nothing here brings, the action is off by default, "
        "or every command in documentation and comments gives the argument"
    },
    examples=(
        Example(
            bad={
                "package.xml": manifest("  <exec_depend>ros2launch</exec_depend>\n"),
                "launch/a.launch.xml": BAD,
            },
            good={"launch/a.launch.xml": GOOD},
        ),
    ),
)
def late_argument(of: ConfigurationsAndPages) -> Iterator[Hit]:
    """
    ## What it does
    Finds launch arguments that an action uses before they are declared in the launch description.

    ## Why is this bad?
    launch visits the actions in order: the launch stops with "launch configuration 'x' does not exist", unless the
    argument is given on the command line. So it works for some, and never with the default.

    ## When it is quiet
    Nothing is said where the argument has been set by a file that includes this one, or where something of an unknown
    name may have set it. An argument without a default has to be given wherever it is declared: without it the launch
    stops before it begins, and given it is set from the start. Where the launch ends before, as it looks for a package
    that nothing here brings, or only an action uses it that is off by default, it is an info; so it is where pages,
    scripts or the comments of the file show commands that start it, and each of these gives the argument.
    """
    configurations = of.configurations
    for each in unset(configurations):
        if each.state == "late":
            why = why_unvisited(configurations.file, each.span, configurations.workspace)
            given = f", {DOCUMENTED}" if of.is_documented(each.name) else ""
            message = (
                f"`{each.name}` is used before it is declared: unless given{given}, the launch stops "
                f"(\"launch configuration '{each.name}' does not exist\"){why and ', '}{why}; move the declaration up"
            )
            yield Hit(configurations.file.path, each.span, message, Severity.INFO if why or given else None)

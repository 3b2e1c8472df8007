"""LCH017 unused-argument."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.launch.launch_configurations import LaunchConfigurations
from ...checks.launch.unset_configurations import unused
from ...example import Example, manifest
from ...finding import Hit, Severity
from ...rule import Profile, rule

BAD = """\
<launch>
  <arg name="rate" default="10"/>
  <«arg» name="mode" default="fast"/>
  <log message="at $(var rate) Hz"/>
</launch>
"""


@rule(
    "LCH017",
    "unused-argument",
    over=LaunchConfigurations,
    severity=Severity.INFO,
    profile=Profile.PEDANTIC,
    examples=(
        Example(
            bad={
                "package.xml": manifest("  <exec_depend>ros2launch</exec_depend>\n"),
                "launch/a.launch.xml": BAD,
            },
            good={"launch/a.launch.xml": BAD.replace('  <«arg» name="mode" default="fast"/>\n', "")},
        ),
    ),
)
def unused_argument(configurations: LaunchConfigurations) -> Iterator[Hit]:
    """
    ## What it does
    Finds launch arguments that a file declares and never uses.

    ## Why is this bad?
    Setting the argument on the command line has no effect, without a warning.

    ## When it is quiet
    Files that include others are left alone, since these see the arguments as well, and so are files that can't be
    evaluated to the end.
    """
    for argument in unused(configurations):
        name = argument.name.literal
        message = f"nothing uses the launch argument `{name}`: setting it has no effect; use it, or remove it"
        yield Hit(configurations.file.path, argument.span, message)

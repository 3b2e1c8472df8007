"""LCH015 include-argument-mismatch."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.launch.argument_mismatch import ArgumentMismatch
from ...checks.launch.include_arguments import IncludeContext
from ...edits.caused_places import level_of, other_places
from ...example import Example, manifest
from ...finding import Hit, Severity
from ...rule import rule

ARM = """\
<launch>
  <arg name="speed"/>
  <arg name="rate" default="1.0"/>
  <let name="twice" value="$(var speed) $(var rate)"/>
</launch>
"""
GIVEN = """\
<launch>
  <include file="$(find-pkg-share my_pkg)/launch/arm.launch.xml">
    <arg name="speed" value="1.0"/>
    <arg name="«ratee»" value="2.0"/>
  </include>
</launch>
"""
LACKS = """\
<launch>
  <«include» file="$(find-pkg-share my_pkg)/launch/arm.launch.xml"/>
</launch>
"""
"""How many names a hint offers; where more are as near, none."""
FILES = {
    "package.xml": manifest("  <exec_depend>ros2launch</exec_depend>\n"),
    "launch/arm.launch.xml": ARM,
}
GOOD = {"launch/robot.launch.xml": GIVEN.replace("«ratee»", "rate")}


@rule(
    "LCH015",
    "include-argument-mismatch",
    over=IncludeContext,
    severity=Severity.WARNING,
    levels={
        Severity.INFO: "an argument without effect that is no slip of one, that a file further on may take, or that is "
        "given with the default of the intended one"
    },
    examples=(
        Example(bad={**FILES, "launch/robot.launch.xml": GIVEN}, good=GOOD),
        Example(bad={**FILES, "launch/robot.launch.xml": LACKS}, good=GOOD),
    ),
)
def include_argument_mismatch(context: IncludeContext) -> Iterator[Hit]:
    """
    ## What it does
    Finds arguments of an included launch file that it does not declare, or that are missing.
    The file is of this package or of another one of the workspace. An argument is unknown if neither it nor anything it
    includes declares or uses it, and missing if it has no default and is not given. Of well-known launch files
    (nav2_bringup, realsense2_camera) a name one letter from an argument is reported. A wrong name that several includes
    of a file give is one finding.

    ## Why is this bad?
    An unknown argument has no effect, without a warning: a value under a misspelt name never arrives. A missing one
    stops the launch: "Included launch description missing required argument 'speed'".

    ## When it is quiet
    An include whose arguments are not all known lacks none.

    It is an info

    - for an unknown argument that is like none that the included file declares, or like many of them: it is left over,
      and nothing fails;
    - where the value is the default of the intended argument;
    - for a name one letter from an argument that is not given, where the included file can't be evaluated to the end,
      or includes something unknown, which may take it;
    - where the include is never added, or every launch ends before, as it looks for a package that nothing here brings.
    """
    for places in context.together():
        first = places[0]
        yield Hit(first.path, first.span, message(first.item), level_of(places), other_places(places))


def message(mismatch: ArgumentMismatch) -> str:
    of = "" if not mismatch.package else f" of `{mismatch.package}`"
    if mismatch.is_missing and mismatch.suggestion:
        return (
            f"`{mismatch.file}`{of} requires an argument `{mismatch.argument}`, and `{mismatch.suggestion}` is given: "
            f'the launch stops ("missing required argument"){mismatch.why}; correct the name'
        )
    if mismatch.is_missing:
        return (
            f"`{mismatch.file}`{of} requires an argument `{mismatch.argument}`, which is not given here: the launch "
            f'stops ("missing required argument"){mismatch.why}; give it'
        )
    if not mismatch.is_sure:
        return (
            f"`{mismatch.file}`{of} declares `{mismatch.suggestion}`, and no `{mismatch.argument}`: unless a file that "
            f"it includes takes that, it has no effect; did you mean `{mismatch.suggestion}`?"
        )
    intended = " or ".join(f"`{each}`" for each in (mismatch.suggestion, *mismatch.rivals))
    hint = f"did you mean {intended}?" if mismatch.is_clear else "remove it, or declare it there"
    same = f", and nothing differs: it is the default of `{mismatch.suggestion}`" if mismatch.is_default else ""
    return (
        f"`{mismatch.file}`{of} takes no argument `{mismatch.argument}`: it has no effect{same}{mismatch.why}; {hint}"
    )

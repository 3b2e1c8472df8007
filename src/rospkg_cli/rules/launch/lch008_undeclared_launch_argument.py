"""LCH008 undeclared-launch-argument."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.launch.documented_arguments import DOCUMENTED, ConfigurationsAndPages
from ...checks.launch.unset_configuration import UnsetConfiguration
from ...checks.launch.unset_configurations import unset
from ...checks.launch.who_meets import why_unmet, why_unvisited
from ...example import Example, manifest
from ...finding import Hit, Severity
from ...package.launch.launch_file import LaunchFile
from ...package.workspace import Workspace
from ...rule import rule
from ...suggest import did_you_mean, is_misspelt

BAD = """\
<launch>
  <arg name="rate" default="10"/>
  <log message="at $(var «rat») Hz"/>
</launch>
"""
BAD_PYTHON = """\
from launch import LaunchDescription
from launch.actions import LogInfo
from launch.substitutions import LaunchConfiguration


def generate_launch_description():
    return LaunchDescription([LogInfo(msg=LaunchConfiguration('«rate»'))])
"""
FEW = 3
"""A file that uses more is probably made to be included by another file that sets them."""

NEEDED = manifest("  <exec_depend>ros2launch</exec_depend>\n")


@rule(
    "LCH008",
    "undeclared-launch-argument",
    over=ConfigurationsAndPages,
    severity=Severity.WARNING,
    levels={
        Severity.INFO: "others include it, or probably do, it declares none, it includes a file that is not here, "
        "nothing reads the variable, every command in documentation and comments gives it, a condition that is off by "
        "default is around it, or the launch ends before at a package that nothing brings"
    },
    examples=(
        Example(
            bad={"package.xml": NEEDED, "launch/a.launch.xml": BAD},
            good={"launch/a.launch.xml": BAD.replace("«rat»", "rate")},
        ),
        Example(
            bad={"package.xml": NEEDED, "launch/a.launch.py": BAD_PYTHON},
            good={"launch/a.launch.py": BAD_PYTHON.replace("'«rate»'", "'rate', default='10'")},
        ),
    ),
)
def undeclared_launch_argument(of: ConfigurationsAndPages) -> Iterator[Hit]:
    """
    ## What it does
    Finds launch configurations that are used without a default and that nothing sets.
    They are used as `LaunchConfiguration('x')`, `$(var x)` or, in an OpaqueFunction,
    `context.launch_configurations['x']`, and no argument of that name is declared in the file, in
    the files that it includes, or in those of the workspace that include it. Arguments that are declared and never
    added to the launch description count as not declared. Where that can't be determined, nothing is reported.

    ## Why is this bad?
    The launch stops with "launch configuration 'x' does not exist".

    ## When it is quiet
    In files that can't be evaluated to the end, or that set configurations of unknown names, a name is reported only if
    it occurs once and is one letter from an argument that is declared and mentioned nowhere else (an info, where it is
    less similar, or nothing reads the variable that it is bound to). A name that has a default is reported on the same
    condition in any file, as an info where the file includes others, which may read the argument.

    It is an info where only a class of the file uses the name; where only the files that include this one set it, and
    this one declares an argument that begins its name (`R` for `roll`) and uses that nowhere; and where other files
    include this one and may set it, or it uses many, or declares none at all: then the user, or the including file,
    must set it. It is an info where the file includes a file that is not here, if it declares other arguments and no
    file of the workspace has that name; where pages, scripts or the comments of the file show commands that start it,
    and each of these gives the argument; and where only actions use it that are never added, or off by default.
    """
    configurations, file = of.configurations, of.configurations.file
    found = [each for each in unset(configurations) if each.state != "late"]
    many = len(found) > FEW
    is_for_others = not any(each.declared for each in found)
    level = Severity.INFO if many or configurations.is_included else None
    for each in found if not (many and configurations.is_included) else ():
        if many and each.is_passed_on:
            continue
        why = idle(each, file, configurations.workspace)
        is_mild = each.may_be_included or each.is_guess or each.is_unread or bool(why)
        is_mild = is_mild or (is_for_others and each.state == "undeclared")
        mild = Severity.INFO if is_mild else level
        better = "; declare it, or give it a default"
        if each.has_default or each.is_inherited:
            message = always_default(each) if each.has_default else only_inherited(each)
            yield Hit(file.path, each.span, f"{message}{why}", mild)
            continue
        if each.state == "not added":
            message = f"the declaration of `{each.name}` is not part of the launch description that is returned"
            better = "; add it"
        else:
            alike = [name for name in each.declared if is_misspelt(each.name, name)]
            hint = did_you_mean(each.name, alike)
            message, better = f"no file declares the launch argument `{each.name}`{hint}", "" if hint else better
        raised = f"KeyError: '{each.name}'" if each.is_lookup else f"launch configuration '{each.name}' does not exist"
        given = f", {DOCUMENTED}" if of.is_documented(each.name) else ""
        unless = "given, or set by a file that it includes" if each.may_be_included else "given"
        stops = f'unless {unless}{given}, the launch stops ("{raised}"){unread(each)}{why}'
        yield Hit(file.path, each.span, f"{message}: {stops}{better}", Severity.INFO if given else mild)


def idle(each: UnsetConfiguration, file: LaunchFile, workspace: Workspace) -> str:
    """Return why no plain launch reaches a use: a lookup in Python raises KeyError, whatever becomes of its value."""
    reason = why_unmet if each.is_lookup else why_unvisited
    why = reason(file, each.span, workspace)
    return f", {why}" if why else ""


def unread(each: UnsetConfiguration) -> str:
    """Return that nothing reads the variable of a use, so that launch does not fail today; "" where something does."""
    return ", as soon as something reads the variable, which nothing does" if each.is_unread else ""


def always_default(each: UnsetConfiguration) -> str:
    """Return what is wrong with a use that has a default, which hides the slip."""
    declared = each.declared[0]
    what = f"no file declares the launch argument `{each.name}`, but `{declared}`, one letter away, which nothing uses"
    return f"{what}: it always has its default, and setting `{declared}` has no effect{unread(each)}; write them alike"


def only_inherited(each: UnsetConfiguration) -> str:
    """Return what is wrong with a use of what only a file that includes this one sets."""
    what = f"this file declares no launch argument `{each.name}`, but `{each.declared[0]}`, which nothing uses"
    return f"{what}: it works where another file includes it and sets that; started itself, the launch stops"

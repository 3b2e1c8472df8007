"""LCH020 repeated-argument."""

from __future__ import annotations

from collections.abc import Iterator

from ...example import Example, manifest
from ...finding import Hit, Related, Severity
from ...package.launch.launch_file import LaunchFile
from ...package.launch.launched_parts import DeclaredArgument
from ...package.launch.text import LaunchText
from ...rule import rule
from ...suggest import near_names

BAD = """\
<launch>
  <arg name="camera1" default="/left"/>
  <«arg» name="camera1" default="/right"/>
  <log message="$(var camera1) and $(var camera2 /middle)"/>
</launch>
"""


@rule(
    "LCH020",
    "repeated-argument",
    over=LaunchFile,
    severity=Severity.WARNING,
    levels={
        Severity.INFO: "no other launch argument is used and not declared, an included file may declare "
        "it, or each use of it has that default"
    },
    examples=(
        Example(
            bad={
                "package.xml": manifest("  <exec_depend>ros2launch</exec_depend>\n"),
                "launch/a.launch.xml": BAD,
            },
            good={"launch/a.launch.xml": BAD.replace('<«arg» name="camera1"', '<arg name="camera2"')},
        ),
    ),
)
def repeated_argument(file: LaunchFile) -> Iterator[Hit]:
    """
    ## What it does
    Finds launch arguments that a file declares twice with different defaults.

    ## Why is this bad?
    The first default stays, the second is never used, and launch says nothing. Often the second should have
    another name, which is then declared nowhere.

    ## When it is quiet
    Declarations under a condition, in groups or functions that may not run, and with the same default or with one that
    is not known are left alone. Where the other name stops the launch, LCH008 reports it. It is an info where no other
    name is used and not declared, where an included file may declare that name, and where each use of it has the
    second default anyway.
    """
    first: dict[str, DeclaredArgument] = {}
    together = () if file.is_ros1 else declared_together(file)
    for argument in file.arguments:
        name = argument.name.literal
        if not name or name not in together or not argument.is_certain:
            continue
        before = first.setdefault(name, argument)
        if before is argument or not differ(before.default, argument.default):
            continue
        intended = intended_by(file, name)
        if intended and is_reported_as_undeclared(file, intended):
            continue
        is_open = any(event.kind in ("open", "include") for event in file.events or ())
        unless = " here, unless a file that it includes does so" if is_open else ""
        hint = (
            f"; did you mean `{intended}`, which is used and not declared{unless}?"
            if intended
            else "; remove one of them"
        )
        is_same = intended is not None and is_default_of(file, intended, argument.default)
        same = f", and nothing differs: each use of `{intended}` has it" if is_same else ""
        text = f"the launch argument `{name}` is declared twice: this second default is never used{same}{hint}"
        again = (Related(file.path, before.span, "declared first"),)
        yield Hit(
            file.path, argument.span, text, None if intended and not is_open and not is_same else Severity.INFO, again
        )


def declared_together(file: LaunchFile) -> set[str]:
    """Return the names that are declared twice in one scope."""
    scopes: list[set[str]] = [set()]
    twice: set[str] = set()
    for event in file.events or ():
        if event.kind == "push":
            scopes.append(set())
        elif event.kind == "pop" and len(scopes) > 1:
            scopes.pop()
        elif event.kind == "declare":
            twice |= {event.name} & scopes[-1]
            scopes[-1].add(event.name)
    return twice


def differ(first: LaunchText | None, second: LaunchText | None) -> bool:
    if first is None or second is None or first.literal is None or second.literal is None:
        return False
    return first.literal != second.literal


def is_default_of(file: LaunchFile, name: str, default: LaunchText | None) -> bool:
    """Return whether each use of a name has a default of its own, which is what the declaration says as well."""
    uses = [event for event in file.events or () if event.kind == "use" and event.name == name]
    return default is not None and all(event.default is not None and event.default == default.literal for event in uses)


def intended_by(file: LaunchFile, name: str) -> str | None:
    """Return the one name nearly like this one that the file uses and never declares or sets."""
    events = file.events or ()
    set_here = {event.name for event in events if event.kind in ("declare", "define")}
    used = {event.name for event in events if event.kind == "use" and event.name} - set_here
    near = near_names(name, used, 1)
    return near[0] if near else None


def is_reported_as_undeclared(file: LaunchFile, name: str) -> bool:
    """Return whether the launch stops at a name, and everything that may set it is known."""
    uses = (event for event in file.events or () if event.kind == "use" and event.name == name)
    is_open = any(event.kind in ("open", "include") for event in file.events or ())
    return not is_open and any(not event.is_optional for event in uses)

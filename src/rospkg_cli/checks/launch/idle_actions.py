"""Actions of a launch file that a plain `ros2 launch` never visits: never added, or under a condition that is off."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from ...languages.python.file import PythonFile
from ...languages.python.unread_values import only_read_in
from ...package.launch.launch_classes import class_of
from ...package.launch.launch_file import LaunchFile
from ...package.launch.never_launched import never_shown
from ...package.launch.uncalled_functions import uncalled_bodies
from ...ros.launch_calls import ACTIONS
from ...source import Span
from ..fault import Level
from .action_conditions import conditional

NEVER_ADDED = "but nothing adds the action"
UNUSED = "but nothing uses the value"
NEVER_CALLED = "but nothing calls the function"
NO_ENTRY = "but only where another launch file calls the function"
OFF = "but only if its condition holds (not by default)"
CONDITIONAL = "but only if its condition holds"
IN_BRANCH = "but only in a branch that is not always taken"


def level_at(file: LaunchFile, span: Span) -> tuple[Level | None, str]:
    """Return the level of a fault in an action, None for the rule's own, and why it is not that."""
    lost = next((each for each in never_shown(file.python) if each.contains(span)), None) if file.python else None
    if file.python is not None and lost is not None:
        maker = file.python.source.slice(lost).partition("(")[0].rpartition(".")[2]
        return "info", NEVER_ADDED if maker in ACTIONS else UNUSED
    if file.python is not None and is_uncalled(file.python, span):
        return "info", NEVER_CALLED
    if file.python is not None and not file.has_entry_point:
        return "warning", NO_ENTRY
    conditions = [each.holds for each in conditional(file) if each.guards(span)]
    if conditions:
        return ("info", OFF) if False in conditions else ("warning", CONDITIONAL)
    if any(each.contains(span) for each in in_branches(file)):
        return "warning", IN_BRANCH
    return None, ""


def level_read(file: LaunchFile, span: Span) -> tuple[Level | None, str]:
    """Return the same for a value that launch uses where it is read: one that only such actions read is like them."""
    level, why = level_at(file, span)
    if level is None and file.python is not None:
        parts = list(conditional(file))
        off = [each.around for each in parts if each.holds is False]
        if is_read_in(file.python, off, span):
            return "info", OFF
        if is_read_in(file.python, [each.around for each in parts], span):
            return "warning", CONDITIONAL
    return level, why


def is_read_in(file: PythonFile, parts: Sequence[Span], span: Span) -> bool:
    """Return whether a place is in a value that is bound to a name, and that only some parts of the file read."""
    return bool(parts) and any(each.contains(span) for each in only_read_in(file, parts))


def is_uncalled(file: PythonFile, span: Span) -> bool:
    """Return whether a place is in a function that launch never calls."""
    return any(each.contains(span) for each in uncalled_bodies(file))


def in_branches(file: LaunchFile) -> Iterator[Span]:
    """Yield the actions that Python makes only under an `if` of its own that can't be evaluated."""
    for call in file.evaluated.calls if file.evaluated and file.python else ():
        if not call.is_certain and call.get("condition") is None and class_of(call) in ACTIONS:
            yield call.span

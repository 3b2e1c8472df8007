"""Where a launch file in Python looks for a package that nothing brings."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from ...languages.python.evaluate.values import Call, Text
from ...package.launch.evaluated_launch import EvaluatedLaunch
from ...package.launch.launch_classes import class_of
from ...package.launch.launch_file import LaunchFile
from ...package.launch.python_events import PERFORMS
from ...package.launch.visit_order import calls_of, visited_actions
from ...ros.launch_calls import ACTIONS
from ...source import Span
from .idle_actions import is_uncalled
from .package_reference import NAME
from .unmet_lookup import UnmetLookup, is_met

FUNCTIONS = dict.fromkeys(
    ("get_package_share_directory", "get_package_share_path", "get_package_prefix"), ("package_name", 0)
)
"""Functions that look for a package when Python calls them, with the argument that names it, and its place."""
LOOKS = dict.fromkeys(("FindPackageShare", "FindPackagePrefix", "FindPackage"), ("package", 0))
"""Substitutions that do so once they are performed."""
MADE = ACTIONS | {"ComposableNode"}
"""What launch visits once; other values may be used before, too."""


def unmet_in_python(file: LaunchFile, launch: EvaluatedLaunch, lacked: set[str]) -> Iterator[UnmetLookup]:
    """Yield the lookups that every launch reaches: what Python looks for itself, and the first place in an action.

    In a function that launch calls, a look-up hides no more than the function.
    """
    whole = Span(0, len(file.source.text))
    for call in launch.calls:
        name = raised_by(call, lacked)
        is_run = call.is_certain and not is_uncalled(launch.file, call.span)
        if name and is_run and not file.is_guarded(name, call.span):
            function = next((each for each in launch.deferred if each.contains(call.span)), whole)
            yield UnmetLookup(name, call.span, (function,), is_early=True)
    actions = visited_actions(file)
    for place, action in enumerate(actions):
        found = next((each for each in calls_of(action, now=True) if named(each, LOOKS) in lacked), None)
        if found is not None and action.is_certain and is_met(file, action.span) and is_met(file, found.span):
            name = named(found, LOOKS)
            if not file.is_guarded(name, found.span):
                behind = (each for one in actions[place:] for each in calls_of(one))
                yield UnmetLookup(name, found.span, tuple(each.span for each in behind if class_of(each) in MADE))
                return


def raised_by(call: Call, lacked: set[str]) -> str:
    """Return the package that Python lacks at a call: a search for it, or `perform` of one; "" for none."""
    performed = calls_of(call.receiver) if call.callee in PERFORMS and call.receiver is not None else ()
    names = (named(call, FUNCTIONS), *(named(each, LOOKS) for each in performed))
    return next((each for each in names if each in lacked), "")


def named(call: Call, classes: Mapping[str, tuple[str, int]]) -> str:
    """Return the package that a call of some classes names in a plain text; "" for none."""
    argument = classes.get(class_of(call))
    value = call.get(*argument) if argument is not None else None
    return value.text if isinstance(value, Text) and NAME.fullmatch(value.text) else ""

"""Functions of other packages that include a launch file, as the calls of launch that they make."""

from __future__ import annotations

from ...languages.python.evaluate.state import EvaluationState
from ...languages.python.evaluate.values import Argument, Call, Sequence, Value

INCLUDES = (
    "launch_pal.include_utils.include_launch_py_description",
    "launch_pal.include_utils.include_scoped_launch_py_description",
)
"""Take the name of a package, and the parts of a path in its share directory."""


def included(machine: EvaluationState, call: Call) -> Value | None:
    """include_launch_py_description(package, parts, …): an IncludeLaunchDescription of that file."""
    package, parts = call.argument("pkg_name", 0), call.get("paths", 1)
    if package is None or not isinstance(parts, Sequence):
        return None
    share = made(call, "launch_ros.substitutions.FindPackageShare", Argument("", package.value, package.span))
    spans = [package.span, *parts.places]
    path = Sequence(call.span, "list", [share, *parts.items], spans, open_conditions=parts.open_conditions)
    joined = made(call, "launch.substitutions.PathJoinSubstitution", Argument("", path, call.span))
    others = [each for each in call.arguments if each.name not in ("", "pkg_name", "paths")]
    source = Argument("", joined, call.span)
    include = made(call, "launch.actions.IncludeLaunchDescription", source, *others)
    machine.calls += [share, joined, include]
    return include


def made(call: Call, callee: str, *arguments: Argument) -> Call:
    return Call(call.span, callee, arguments, is_certain=call.is_certain, rest=call.rest)


KNOWN = dict.fromkeys(INCLUDES, included)

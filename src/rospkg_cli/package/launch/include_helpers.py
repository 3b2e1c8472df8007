"""Functions of other packages that include a launch file, as the calls of launch that they make."""

from __future__ import annotations

from ...languages.python.evaluate.dict_methods import views
from ...languages.python.evaluate.state import EvaluationState
from ...languages.python.evaluate.values import Argument, Call, Mapping, Sequence, Value
from ...light_dataclasses import replace
from .launch_classes import class_of

INCLUDES = (
    "launch_pal.include_utils.include_launch_py_description",
    "launch_pal.include_utils.include_scoped_launch_py_description",
)
"""Take the name of a package, and the parts of a path in its share directory."""
SCOPED = INCLUDES[1]
"""Takes the arguments as a dict, of which it hands on the items."""
OF_THE_GROUP = frozenset({"env_vars", "namespace"})
"""What it gives to the group around the include."""


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
    if call.callee == SCOPED:
        others = [with_items(machine, each) for each in others if each.name not in OF_THE_GROUP]
    source = Argument("", joined, call.span)
    include = made(call, "launch.actions.IncludeLaunchDescription", source, *others)
    machine.calls += [share, joined, include]
    return include


def with_items(machine: EvaluationState, argument: Argument) -> Argument:
    """Return a dict of launch arguments as its items; an action that declares one is taken for its value."""
    given = argument.value
    if argument.name != "launch_arguments" or not isinstance(given, Mapping):
        return argument
    pairs = {key: (name, passed(machine, value)) for key, (name, value) in given.items.items()}
    items = views(machine, replace(given, items=pairs), Call(given.span, "items"))
    return argument if items is None else replace(argument, value=items)


def passed(machine: EvaluationState, value: Value) -> Value:
    declares = isinstance(value, Call) and class_of(value) == "DeclareLaunchArgument"
    return machine.unknown(value.span, "the launch gives it") if declares else value


def made(call: Call, callee: str, *arguments: Argument) -> Call:
    return Call(call.span, callee, arguments, is_certain=call.is_certain, rest=call.rest)


KNOWN = dict.fromkeys(INCLUDES, included)

"""What is passed as `parameters`, compared with what launch_ros takes (normalize_parameters): dicts and files."""

from __future__ import annotations

from collections.abc import Iterator

from ...languages.python.evaluate.values import (
    Argument,
    Call,
    Class,
    Constant,
    Function,
    PartialText,
    Sequence,
    Text,
    Unknown,
    Value,
)
from ...languages.python.evaluate.values import Mapping as Dict
from ...package.launch.launch_classes import class_of, is_substitution, span_within, type_name, value_span
from ...ros.launch_calls import ACTIONS, CONDITIONS
from ...source import Span
from ..fault import Fault

RAISES = "launch_ros raises TypeError"
OBJECTS = ACTIONS | CONDITIONS | {"LaunchDescription", "ComposableNode"}
MOVEIT, MAKES_MOVEIT = "MoveItConfigs", "to_moveit_configs"
ONE_FILE = frozenset({"ParameterFile"})
REWRITTEN = frozenset({"nav2_common.launch.RewrittenYaml", "nav2_common.launch.ReplaceString"})
"""Substitutions of navigation that are the path of a parameter file."""


def parameters_faults(argument: Argument, what: str) -> Iterator[Fault]:
    """launch_ros takes a list of dicts and of files."""
    value, place = argument.value, value_span(argument)
    if name := single_parameters(value):
        yield Fault(place, f"{what} takes a list of dicts and files, not {name}: write `[…]`")
    for item in value.items if isinstance(value, Sequence) else ():
        at, holds = span_within(item, place), f"{what} holds dicts and files"
        if isinstance(item, Sequence) and item.kind == "set" and not is_path_alone(item):
            yield a_set(item, at, what)
        elif isinstance(item, Sequence) and any(isinstance(each, Dict) for each in item.items):
            yield Fault(at, f"{holds}, and this is a list inside the list: {RAISES}; put a `*` before it")
        elif isinstance(item, Constant):
            yield Fault(at, f"{holds}, not {type_name(item)}: {RAISES}")
        elif name := (object_name(item) or named_value(item)):
            yield Fault(at, f"{holds}, not {name}: {RAISES}{advice(item)}")
        elif isinstance(item, Dict) and (named := named_in_pair(item)):
            message = f"this sets two parameters, `name` and `value`, and not `{named}`: write `{{'{named}': …}}`"
            yield Fault(at, message, "warning")
        elif isinstance(item, Dict):
            yield from parameter_value_faults(item, at)


def a_set(items: Sequence, place: Span, what: str) -> Fault:
    """Return what is wrong with a set: launch_ros joins texts to the path of a file, and stops at other values."""
    message = f"this is a set and no dict of {what}: write `:` between a name and its value"
    is_joined = all(isinstance(each, Text | PartialText) or is_substitution(each) for each in items.items)
    return Fault(place, message, "warning" if is_joined else None)


def is_path_alone(items: Sequence) -> bool:
    """Return whether a set holds one text or substitution: launch_ros joins what it holds to the path of a file."""
    return len(items.items) == 1 and (isinstance(items.items[0], Text | PartialText) or is_substitution(items.items[0]))


def named_in_pair(values: Dict) -> str:
    """Return the parameter that a pair of `name` and `value` is intended for, as `<param>` has them; "" for others."""
    found = {key.text: value for key, value in values.items.values() if isinstance(key, Text)}
    named = found.get("name")
    return named.text if found.keys() == {"name", "value"} and isinstance(named, Text) else ""


def single_parameters(value: Value) -> str:
    """Return what a value is that belongs into a list of parameters, and is none; "" for anything else."""
    if isinstance(value, Unknown) and value.options:
        names = {single_parameters(each) for each in value.options}
        return names.pop() if len(names) == 1 else ""
    if isinstance(value, Dict | Text | PartialText | Constant) or is_substitution(value):
        return type_name(value)
    if isinstance(value, Call) and (class_of(value) in ONE_FILE or value.callee in REWRITTEN):
        return f"`{value.callee.rpartition('.')[2]}`"
    return "a dict" if isinstance(value, Call) and value.receiver is not None and value.callee == "to_dict" else ""


def object_name(value: Value) -> str:
    """Return what a value is that no parameter can be: an action, a condition, a function; "" for anything else."""
    if isinstance(value, Function | Class):
        return f"the {'class' if isinstance(value, Class) else 'function'} `{value.name}`"
    if not isinstance(value, Call):
        return ""
    if value.receiver is not None:
        return f"`{MOVEIT}`" if value.callee == MAKES_MOVEIT else ""
    return f"`{class_of(value)}`" if class_of(value) in OBJECTS else ""


def named_value(item: Value) -> str:
    """Return the class of a value that belongs into a dict, behind its name."""
    return "`ParameterValue`" if isinstance(item, Call) and class_of(item) == "ParameterValue" else ""


def advice(item: Value) -> str:
    is_moveit = isinstance(item, Call) and item.callee == MAKES_MOVEIT
    return "; write `.to_dict()` behind it" if is_moveit else "; write it as `{'name': …}`" if named_value(item) else ""


def parameter_value_faults(values: Dict, place: Span) -> Iterator[Fault]:
    for key, value in values.items.values():
        name, at = key.text if isinstance(key, Text) else "a parameter", span_within(value, place)
        if isinstance(value, Dict):
            yield from parameter_value_faults(value, place)
        elif isinstance(value, Constant) and value.value is None:
            yield Fault(at, f"`{name}` is None, and a parameter has no such type: {RAISES}")
        elif kind := object_name(value):
            yield Fault(at, f"`{name}` is {kind}, and a parameter has no such type: {RAISES}")
        elif isinstance(value, Sequence) and value.kind == "set":
            yield Fault(at, f"`{name}` is a set, and a parameter has no such type: {RAISES}; use a list")
        elif isinstance(value, Sequence) and not value.items:
            yield Fault(at, f"`{name}` is an empty list, which has no type: {RAISES}")

"""What an evaluated value is to launch: which of its classes a call makes, its arguments by name, its type in words."""

from __future__ import annotations

from collections.abc import Iterator

from ...languages.python.evaluate.values import Argument, Call, Constant, Mapping, PartialText, Sequence, Text, Value
from ...ros.launch_calls import CONDITIONS, SUBSTITUTIONS, Signature
from ...source import Span

HOMES = frozenset({"launch", "launch_ros", "ament_index_python"})
SOURCES = frozenset({"launch_xml", "launch_yaml"})
MODULES = HOMES | SOURCES


def class_of(call: Call) -> str:
    """Return the class or function of launch that a call makes, without its module; "" for any other."""
    if call.receiver is not None:
        return ""
    home, _, name = call.callee.partition(".")
    return name.rpartition(".")[2] if home in MODULES else ""


def named_arguments(call: Call, signature: Signature) -> Iterator[tuple[str, Argument]]:
    """Yield each argument that is passed with the name that it has in the class."""
    positional = iter(signature.positional)
    for argument in call.arguments:
        name = argument.name or next(positional, "")
        if name:
            yield name, argument


def is_substitution(value: Value) -> bool:
    """Return whether a value is certainly a substitution: launch knows its text only at run time."""
    return isinstance(value, Call) and class_of(value) in SUBSTITUTIONS


def is_condition(value: Value) -> bool:
    return isinstance(value, Call) and class_of(value) in CONDITIONS


def is_resolved_at_run_time(value: Value) -> bool:
    return is_substitution(value) or is_condition(value)


def type_name(value: Value) -> str:
    """Return what a value is, as a sentence names it: "a dict", "the int `1`"; "" where it is unknown."""
    match value:
        case Constant():
            return "`None`" if value.value is None else f"the {type(value.value).__name__} `{value.value}`"
        case Text() | PartialText():
            return "a path" if value.is_path else "a string"
        case Sequence():
            return f"a {value.kind}"
        case Mapping():
            return "a dict"
        case Call() if class_of(value)[:1].isupper():
            return f"`{class_of(value)}`"
    return ""


def value_span(argument: Argument) -> Span:
    """Return the span of an argument's value; of the whole argument where the value was computed elsewhere."""
    return span_within(argument.value, argument.span)


def span_within(value: Value, outer: Span) -> Span:
    """Return the span of a value that is written inside of another span; else that other span."""
    is_inside = outer.contains(value.span)
    return value.span if is_inside else outer

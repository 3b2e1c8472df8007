"""What launch can't do with what a Python launch file hands it."""

from __future__ import annotations

from dataclasses import dataclass

from ...languages.python.evaluate.values import Argument, Call, Constant, Joined, Mapping, Sequence, Text, Value
from ...ros.launch_calls import CONDITIONS, SUBSTITUTIONS
from ...source import Span
from .values import class_of


@dataclass(frozen=True, slots=True)
class Misuse:
    """A call that raises, or that can't do what it says; `mend` is the text that would be right at a span."""

    span: Span
    message: str
    mend: tuple[Span, str] | None = None


def is_substitution(value: Value) -> bool:
    """Return whether a value is for certain a substitution: launch knows its text only when it runs."""
    return isinstance(value, Call) and class_of(value) in SUBSTITUTIONS


def is_condition(value: Value) -> bool:
    return isinstance(value, Call) and class_of(value) in CONDITIONS


def is_late(value: Value) -> bool:
    return is_substitution(value) or is_condition(value)


def kind_of(value: Value) -> str:
    """Return what a value is, as a sentence names it; "" where that can't be told."""
    match value:
        case Constant():
            return "`None`" if value.value is None else f"the {type(value.value).__name__} `{value.value}`"
        case Text() | Joined():
            return "a path" if value.path else "a text"
        case Sequence():
            return f"a {value.kind}"
        case Mapping():
            return "a dict"
        case Call() if class_of(value)[:1].isupper():
            return f"`{class_of(value)}`"
    return ""


def place_of(given: Argument) -> Span:
    """Return where the value of an argument stands: the name of a variable is where it is handed over."""
    return within(given.value, given.span)


def within(value: Value, place: Span) -> Span:
    """Return the span of a value that is written inside of a place, else the place."""
    inside = place.start <= value.span.start and value.span.end <= place.end
    return value.span if inside else place

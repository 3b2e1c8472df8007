"""Iteration over values, and functions over plain values."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from ....unreadable import UnreadableError
from .conversion import NoPythonValueError, from_python, to_python
from .limits import ITEM, spend
from .state import EvaluationState, Intrinsic
from .values import Call, OpenedFile, Sequence, Text, Unknown, Value
from .values import Mapping as MappingValue


def items_of(state: EvaluationState, value: Value) -> list[Value] | None:
    """Return the items of an iterable; None where they are unknown."""
    match value:
        case Sequence():
            spend(len(value.items) * ITEM)
            return list(value.items)
        case MappingValue():
            spend(len(value.items) * ITEM)
            rest = [state.unknown(value.span, each.why, many=True) for each in value.rest[:1]]
            return [as_doubtful(item, (key,)) or key for key, item in value.items.values()] + rest
        case Text() if not value.is_path:
            state.tick(len(value.text))
            return [Text(value.span, char) for char in value.text]
        case OpenedFile():
            left = read_rest(state, value)
            lines = [] if left is None else left.splitlines(keepends=True)
            state.tick(len(lines))
            return None if left is None else [Text(value.span, line) for line in lines]
    return None


def as_doubtful(item: Value, options: tuple[Value, ...]) -> Unknown | None:
    """Return what stands for a key of a dict, or for its pair, where it is only perhaps there; else None."""
    return (
        Unknown(item.span, item.why, is_many=True, options=options)
        if isinstance(item, Unknown) and item.is_many
        else None
    )


def read_rest(state: EvaluationState, opened: OpenedFile) -> str | None:
    """Return the unread rest of a file, and advance to its end; None where the file has no text."""
    try:
        text = state.folder.files.source(opened.path).text
    except UnreadableError:
        return None
    state.tick(len(text) // 100)
    rest, opened.at = text[opened.at :], len(text)
    return rest


def is_many(item: Value) -> bool:
    return isinstance(item, Unknown) and item.is_many


def plain_function(function: Callable[..., Any]) -> Intrinsic:
    """Return the intrinsic of a function over plain values; it must be cheap for all arguments."""

    def intrinsic(state: EvaluationState, call: Call) -> Value | None:
        try:
            positional = [to_python(value) for value in call.positional]
            named = {argument.name: to_python(argument.value) for argument in call.arguments if argument.name}
            return from_python(function(*positional, **named), call.span)
        except (NoPythonValueError, TypeError, ValueError, LookupError, AttributeError, ArithmeticError):
            return None

    return intrinsic

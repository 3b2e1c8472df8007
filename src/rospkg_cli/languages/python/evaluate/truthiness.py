"""Truth, equality and containment of values: None where that is unknown."""

from __future__ import annotations

import ast
import operator
from collections.abc import Callable
from typing import Any

from ..nodes import COMPARISONS
from .conversion import NoPythonValueError, to_python
from .values import Class, Constant, Function, Mapping, OpenedFile, PartialText, Sequence, Symbol, Text, Unknown, Value

SIGNS: dict[type, Callable[[Any, Any], Any]] = {
    **COMPARISONS,
    ast.In: lambda a, b: a in b,
    ast.NotIn: lambda a, b: a not in b,
    ast.Is: operator.is_,
    ast.IsNot: operator.is_not,
}


def truth(value: Value) -> bool | None:
    """Return whether a value counts as true; None where that is unknown."""
    match value:
        case Symbol() | Function() | Class() | OpenedFile():
            return True
        case Sequence() if any(not (isinstance(item, Unknown) and item.is_many) for item in value.items):
            return True
        case Mapping() if any(not (isinstance(item, Unknown) and item.is_many) for _, item in value.items.values()):
            return True
        case PartialText() if any(isinstance(part, Text) for part in value.parts):
            return True
    try:
        return bool(to_python(value))
    except NoPythonValueError:
        return None


def compare(kind: type, left: Value, right: Value) -> bool | None:
    if kind in (ast.In, ast.NotIn) and isinstance(right, Mapping) and right.is_complete:
        right = Sequence(right.span, "list", [key for key, _ in right.items.values()])
    if kind in (ast.Is, ast.IsNot, ast.Eq, ast.NotEq) and is_none(right) and not_none(left):
        return kind in (ast.IsNot, ast.NotEq)
    try:
        return bool(SIGNS[kind](to_python(left), to_python(right)))
    except (NoPythonValueError, TypeError, KeyError):
        return None


def is_none(value: Value) -> bool:
    return isinstance(value, Constant) and value.value is None


def not_none(value: Value) -> bool:
    return isinstance(value, Symbol | Function | Class | Sequence | Mapping | PartialText | Text | OpenedFile)

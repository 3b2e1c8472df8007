"""Operators over values: each returns None where the result is unknown or Python would raise."""

from __future__ import annotations

import ast
import operator
import posixpath
from collections.abc import Callable
from typing import Any

from ....light_dataclasses import replace
from ....source import Span
from .conversion import NoPythonValueError, from_python, join_texts, to_python
from .dict_methods import merge
from .formatting import percent_format
from .limits import ITEM, MAX_ITEMS, MAX_TEXT, STEP, spend
from .values import (
    AttributeValue,
    Call,
    Constant,
    Mapping,
    PartialText,
    Sequence,
    Symbol,
    Text,
    Unknown,
    Value,
)

LARGE = 2**64

ARITHMETIC: dict[type, Callable[[Any, Any], Any]] = {
    ast.Add: operator.add,
    ast.Sub: operator.sub,
    ast.Mult: operator.mul,
    ast.Div: operator.truediv,
    ast.FloorDiv: operator.floordiv,
    ast.Mod: operator.mod,
    ast.BitOr: operator.or_,
    ast.BitAnd: operator.and_,
    ast.BitXor: operator.xor,
}


def binary_operation(kind: type, left: Value, right: Value, span: Span) -> Value | None:
    if kind is ast.Add and (found := concatenate(left, right, span)) is not None:
        return found
    if (kind is ast.Div and is_path(left)) or (kind is ast.Div and is_path(right)):
        return path_join([left, right], span, path=True)
    if kind is ast.Mod and isinstance(left, Text):
        return percent_format(left.text, right, span)
    if kind is ast.Mult and isinstance(left, Sequence | Text):
        return repeat(left, right, span)
    if kind is ast.BitOr and isinstance(left, Mapping) and isinstance(right, Mapping):
        result = Mapping(span)
        merge(result, left)
        merge(result, right)
        return result
    return compute(kind, left, right, span)


def compute(kind: type, left: Value, right: Value, span: Span) -> Value | None:
    """Return the result over numbers or sets."""
    try:
        a, b = to_python(left), to_python(right)
        if kind not in ARITHMETIC or not (is_small(a) and is_small(b)):
            return None
        return from_python(ARITHMETIC[kind](a, b), span)
    except (NoPythonValueError, TypeError, ValueError, ArithmeticError):
        return None


def is_small(operand: object) -> bool:
    """Return whether the result of an operator is certainly small: bounded numbers, and sets."""
    return isinstance(operand, set) or (isinstance(operand, int | float) and abs(operand) < LARGE)


def concatenate(left: Value, right: Value, span: Span) -> Value | None:
    if isinstance(left, Sequence) or isinstance(right, Sequence):
        return concatenate_sequences(left, right, span)
    textual = isinstance(left, Text | PartialText), isinstance(right, Text | PartialText)
    if not any(textual) or isinstance(left, Constant) or isinstance(right, Constant):
        return None
    if all(textual) or isinstance(left if textual[1] else right, Call | Unknown | AttributeValue | Symbol):
        return join_texts([left, right], span)
    return None


def concatenate_sequences(left: Value, right: Value, span: Span) -> Value | None:
    """Return the items of two sequences in a new one; for an unknown one it holds an Unknown."""
    result = Sequence(span, left.kind if isinstance(left, Sequence) else right.kind)  # type: ignore[union-attr]
    for side in (left, right):
        if isinstance(side, Sequence) and side.kind == result.kind:
            if len(result.items) + len(side.items) > MAX_ITEMS:
                return None
            spend(len(side.items) * STEP)
            result.items += side.items
            result.places += side.places
        elif isinstance(side, Unknown | Call | AttributeValue | Symbol):
            why = side.why if isinstance(side, Unknown) else "it comes from a call that can't be evaluated"
            result.add(Unknown(side.span, why, is_many=True), side.span)
        else:
            return None
    return result


def repeat(left: Sequence | Text, right: Value, span: Span) -> Value | None:
    times = right.value if isinstance(right, Constant) else None
    if not isinstance(times, int) or times < 0:
        return None
    if isinstance(left, Text):
        if len(left.text) * times > MAX_TEXT:
            return None
        spend(len(left.text) * times)
        return Text(span, left.text * times)
    if len(left.items) * times > MAX_ITEMS:
        return None
    spend(len(left.items) * times * STEP)
    return Sequence(span, left.kind, left.items * times, left.places * times)


def is_path(value: Value) -> bool:
    return isinstance(value, Text | PartialText) and value.is_path


def path_join(parts: list[Value], span: Span, *, path: bool = False) -> Value | None:
    """Return the parts joined as os.path.join does it; the first may be unknown, others in part.

    For paths that are joined with `/`, the second part may be a call.
    """
    if path and len(parts) == 2 and isinstance(parts[0], PartialText) and isinstance(parts[1], Call):
        return join_texts([parts[0], Text(span, "/"), parts[1]], span, path=True)
    spend(len(parts) * ITEM)
    size = sum(len(part.text) + 1 for part in parts if isinstance(part, Text))
    if not parts or size > MAX_TEXT or not all(isinstance(part, Text | PartialText) for part in parts[1:]):
        return None
    spend(size)
    if all(isinstance(part, Text) for part in parts):
        found = posixpath.join(*(part.text for part in parts if isinstance(part, Text)))
        return Text(span, normalized_path(found) if path else found, is_path=path)
    if not isinstance(parts[0], Text | Call | PartialText | Unknown | AttributeValue):
        return None
    return join_texts(joined_parts(parts, span), span, path=path)


def joined_parts(parts: list[Value], span: Span) -> list[Value]:
    """Return the parts with slashes between them; what comes before an absolute one is left out."""
    found: list[Value] = []
    for part in parts:
        start = part.parts[0] if isinstance(part, PartialText) and part.parts else part
        if isinstance(start, Text) and start.text.startswith("/"):
            found = []
        elif found and not (isinstance(found[-1], Text) and found[-1].text.endswith("/")):
            found.append(Text(span, "/"))
        found.append(part)
    return found


def normalized_path(text: str) -> str:
    """Return a path as pathlib writes it: no double slashes, no single dots."""
    parts = [part for part in text.split("/") if part not in ("", ".")]
    return ("/" if text.startswith("/") else "") + "/".join(parts) or "."


def subscript(value: Value, index: Value, span: Span) -> Value | None:
    if isinstance(value, Mapping):
        try:
            found = value.items.get(to_python(index))
        except (NoPythonValueError, TypeError):
            return None
        return certainly(found[1]) if found and not value.rest else None
    at = index.value if isinstance(index, Constant) else None
    if not isinstance(at, int):
        return None
    try:
        if isinstance(value, Sequence) and value.kind != "set":
            before = value.items[: at + 1] if at >= 0 else value.items[at:]
            spend(len(before))
            return None if any(isinstance(i, Unknown) and i.is_many for i in before) else value.items[at]
        return Text(span, value.text[at]) if isinstance(value, Text) else None
    except IndexError:
        return None


def certainly(item: Value) -> Value:
    """Return the value of a key that is there, since Python goes on."""
    return replace(item, is_many=False) if isinstance(item, Unknown) and item.is_many else item


def slice_of(value: Value, bounds: slice, span: Span) -> Value | None:
    if isinstance(value, Text) and not value.is_path:
        part = value.text[bounds]
        spend(len(part))
        return Text(span, part)
    if isinstance(value, Sequence) and value.kind != "set" and value.is_complete:
        spend(len(value.items) * ITEM)
        return replace(value, span=span, items=value.items[bounds], places=value.places[bounds], is_display=False)
    return None

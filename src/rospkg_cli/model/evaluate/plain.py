"""Between values and plain Python objects, and what can be said of a value without evaluating it."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import replace

from ...source import Span
from .values import Constant, Joined, Kind, Mapping, Sequence, Symbol, Text, Unknown, Value


class NotPlainError(Exception):
    """A value, or a part of it, has no plain Python counterpart."""


MAX_DEPTH = 40
"""Deeper than this, a container may well hold itself."""


def plain(value: Value, depth: int = 0) -> object:
    """Return the Python value; raises NotPlainError where anything in it is not known."""
    match value:
        case Text():
            return value.text
        case Constant():
            return value.value
        case Sequence() if depth <= MAX_DEPTH:
            items = [plain(item, depth + 1) for item in value.items]
            return items if value.kind == "list" else as_set(items) if value.kind == "set" else tuple(items)
        case Mapping() if depth <= MAX_DEPTH and not value.rest:
            return {key: plain(item, depth + 1) for key, (_, item) in value.items.items()}
    raise NotPlainError


def as_set(items: list[object]) -> set[object]:
    try:
        return set(items)
    except TypeError:
        raise NotPlainError from None


def lift(found: object, span: Span, *, path: bool = False) -> Value:
    """Return the value of a plain Python object."""
    if isinstance(found, str):
        return Text(span, found, path=path)
    if isinstance(found, list | tuple | set | frozenset):
        kind: Kind = "list" if isinstance(found, list) else "tuple" if isinstance(found, tuple) else "set"
        ordered: Iterable[object] = sorted(found, key=repr) if kind == "set" else found
        items = [lift(item, span, path=path) for item in ordered]
        return Sequence(span, kind, items, [span] * len(items))
    if isinstance(found, dict):
        return Mapping(span, {key: (lift(key, span), lift(item, span)) for key, item in found.items()})
    return Constant(span, found)


def known(value: Value) -> bool:
    try:
        plain(value)
    except NotPlainError:
        return False
    return True


def same(a: Value, b: Value) -> bool:
    """Return whether two values are equal for certain."""
    if a is b:
        return True
    if isinstance(a, Symbol) and isinstance(b, Symbol):
        return a.name == b.name
    try:
        return type(a) is type(b) and plain(a) == plain(b)
    except NotPlainError:
        return False


def unknowns(value: Value, depth: int = 0) -> Iterator[Unknown]:
    """Yield every Unknown in a value, in order."""
    inner: Iterable[Value] = ()
    match value:
        case Unknown():
            yield value
        case Sequence():
            inner = value.items
        case Mapping():
            yield from value.rest
            inner = [item for _, item in value.items.values()]
        case Joined():
            inner = value.parts
    if depth <= MAX_DEPTH:
        for item in inner:
            yield from unknowns(item, depth + 1)


def join(parts: Iterable[Value], span: Span, *, path: bool = False) -> Value:
    """Return the text of parts one after the other: a Text where all of them are, else a Joined."""
    flat: list[Value] = []
    for part in parts:
        for each in part.parts if isinstance(part, Joined) else (part,):
            if isinstance(each, Text) and flat and isinstance(flat[-1], Text):
                flat[-1] = Text(span, flat[-1].text + each.text)
            elif not isinstance(each, Text) or each.text:
                flat.append(each)
    if not flat:
        return Text(span, "", path=path)
    if len(flat) == 1 and isinstance(flat[0], Text):
        return replace(flat[0], span=span, literal=None, path=path)
    return Joined(span, tuple(flat), path)

"""Conversion between values and plain Python objects; size, equality and unknown parts of values."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from itertools import groupby

from ....light_dataclasses import dataclass, replace
from ....source import Span
from .limits import ITEM, MAX_TEXT, STEP, spend
from .values import AttributeValue, Call, Constant, Kind, Mapping, PartialText, Sequence, Symbol, Text, Unknown, Value


class NoPythonValueError(Exception):
    """A value, or a part of it, has no plain Python counterpart."""


MAX_DEPTH = 40
"""Deeper than this, a container may well hold itself."""


MAX_NODES = 100_000
"""The values in a value; a shared one counts twice."""


def to_python(value: Value) -> object:
    """Return the Python value; raises NotPlainError where anything in it is not known, or where it is too large."""
    if isinstance(value, Constant):
        spend(ITEM)
        return value.value
    if isinstance(value, Text):
        spend(ITEM + len(value.text) // 10)
        return value.text
    meter = PythonConverter()
    try:
        return meter.of(value, 0)
    finally:
        spend(meter.nodes * ITEM + meter.characters // 10)


@dataclass
class PythonConverter:
    """Converts a value, and counts nodes and characters."""

    nodes: int = 0
    characters: int = 0

    def of(self, value: Value, depth: int) -> object:
        self.nodes += 1
        if self.nodes > MAX_NODES or self.characters > MAX_TEXT or depth > MAX_DEPTH:
            raise NoPythonValueError
        match value:
            case Text():
                self.characters += len(value.text)
                return value.text
            case Constant():
                return value.value
            case Sequence():
                items = [self.of(item, depth + 1) for item in value.items]
                return items if value.kind == "list" else hashable_set(items) if value.kind == "set" else tuple(items)
            case Mapping() if not value.rest:
                return {key: self.of(item, depth + 1) for key, (_, item) in value.items.items()}
        raise NoPythonValueError


def weight_of(value: Value, limit: int) -> int:
    """Return how many values a value holds, one that is held twice counted twice; stops soon after the limit."""
    found, waiting = 0, [value]
    while waiting and found <= limit:
        found += 1
        match waiting.pop():
            case Sequence(items=items):
                waiting += items
            case Mapping(items=entries, rest=rest):
                waiting += [each for pair in entries.values() for each in pair]
                waiting += rest
            case PartialText(parts=parts):
                waiting += parts
            case Unknown(options=options):
                waiting += options
            case Call(arguments=arguments, receiver=receiver):
                waiting += [argument.value for argument in arguments]
                waiting += [receiver] if receiver is not None else []
            case AttributeValue(of=of):
                waiting.append(of)
    return found + len(waiting) if found > limit else found


def hashable_set(items: list[object]) -> set[object]:
    try:
        return set(items)
    except TypeError:
        raise NoPythonValueError from None


def from_python(found: object, span: Span, *, path: bool = False) -> Value:
    """Return the value of a plain Python object."""
    if isinstance(found, str):
        spend(len(found))
        return Text(span, found, is_path=path)
    if isinstance(found, list | tuple | set | frozenset | dict):
        spend(len(found) * STEP)
    if isinstance(found, list | tuple | set | frozenset):
        kind: Kind = "list" if isinstance(found, list) else "tuple" if isinstance(found, tuple) else "set"
        ordered: Iterable[object] = sorted(found, key=repr) if kind == "set" else found
        items = [from_python(item, span, path=path) for item in ordered]
        return Sequence(span, kind, items, [span] * len(items))
    if isinstance(found, dict):
        return Mapping(span, {key: (from_python(key, span), from_python(item, span)) for key, item in found.items()})
    return Constant(span, found)


def is_known(value: Value) -> bool:
    try:
        to_python(value)
    except NoPythonValueError:
        return False
    return True


def is_equal(a: Value, b: Value) -> bool:
    """Return whether two values are equal for certain."""
    if a is b:
        return True
    if isinstance(a, Symbol) and isinstance(b, Symbol):
        return a.name == b.name
    try:
        return type(a) is type(b) and to_python(a) == to_python(b)
    except NoPythonValueError:
        return False


def unknowns(value: Value, seen: set[int] | None = None) -> Iterator[Unknown]:
    """Yield every Unknown in a value, in order; a shared value is visited once."""
    seen = set() if seen is None else seen
    if isinstance(value, Unknown):
        yield value
        return
    if id(value) in seen or len(seen) > MAX_NODES:
        return
    inner: Iterable[Value] = ()
    match value:
        case Sequence():
            inner = value.items
        case Mapping():
            yield from value.rest
            inner = [item for _, item in value.items.values()]
        case PartialText():
            inner = value.parts
    if inner:
        seen.add(id(value))
    for item in inner:
        yield from unknowns(item, seen)


def merge_texts(texts: list[Text], span: Span) -> list[Text]:
    """Return texts joined to one at the span of all; a single one keeps its span, empty ones are dropped."""
    start = next((index for index, each in enumerate(texts) if each.text), len(texts))
    if len(texts) - start < 2:
        return texts[start:]
    return [Text(span, "".join(each.text for each in texts))]


def join_texts(parts: Iterable[Value], span: Span, *, path: bool = False) -> Value:
    """Return the text of parts one after the other: a Text where all of them are, else a PartialText."""
    pieces = [each for part in parts for each in (part.parts if isinstance(part, PartialText) else (part,))]
    size = sum(len(each.text) for each in pieces if isinstance(each, Text))
    spend(len(pieces) * 2 * ITEM)
    if size > MAX_TEXT:
        return Unknown(span, f"a text of more than {MAX_TEXT:,} characters")
    spend(size)
    flat: list[Value] = []
    for _, group in groupby(pieces, lambda each: isinstance(each, Text)):
        several = list(group)
        texts = [each for each in several if isinstance(each, Text)]
        flat += merge_texts(texts, span) if texts else several
    if not flat:
        return Text(span, "", is_path=path)
    if len(flat) == 1 and isinstance(flat[0], Text):
        return replace(flat[0], span=span, literal=None, is_path=path)
    return PartialText(span, tuple(flat), path)

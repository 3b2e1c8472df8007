"""What is passed as parameters and remappings, against what launch_ros makes of it (normalize_parameters)."""

from __future__ import annotations

from collections.abc import Iterator

from ...languages.python.evaluate.values import Argument, Constant, Joined, Mapping, Sequence, Text, Value
from ...source import Span
from .misuse import Misuse, is_substitution, kind_of, place_of, within

RAISES = "launch_ros raises TypeError"


def not_parameters(given: Argument, what: str) -> Iterator[Misuse]:
    value = given.value
    if isinstance(value, Mapping | Text | Joined | Constant) or is_substitution(value):
        yield Misuse(place_of(given), f"{what} takes a list of dicts and files, not {kind_of(value)}: write `[…]`")
    for item in value.items if isinstance(value, Sequence) else ():
        yield from not_a_parameter(item, within(item, place_of(given)), what)


def not_a_parameter(item: Value, place: Span, what: str) -> Iterator[Misuse]:
    if isinstance(item, Sequence) and item.kind == "set":
        yield Misuse(place, f"this is a set and no dict of {what}: write `:` between a name and its value")
    elif isinstance(item, Sequence) and any(isinstance(each, Mapping) for each in item.items):
        yield Misuse(place, f"{what} holds dicts and files, and this is a list of its own: {RAISES}; use `*`")
    elif isinstance(item, Constant):
        yield Misuse(place, f"{what} holds dicts and files, not {kind_of(item)}: {RAISES}")
    elif isinstance(item, Mapping):
        yield from not_values(item, place)


def not_values(given: Mapping, place: Span) -> Iterator[Misuse]:
    for key, value in given.items.values():
        name, at = key.text if isinstance(key, Text) else "a parameter", within(value, place)
        if isinstance(value, Mapping):
            yield from not_values(value, place)
        elif isinstance(value, Constant) and value.value is None:
            yield Misuse(at, f"`{name}` is given None, and a parameter has no such type: {RAISES}")
        elif isinstance(value, Sequence) and value.kind == "set":
            yield Misuse(at, f"`{name}` is given a set, and a parameter has no such type: {RAISES}; use a list")
        elif isinstance(value, Sequence) and not value.items:
            yield Misuse(at, f"`{name}` is given an empty list, whose type nobody can tell: {RAISES}")


def not_remappings(given: Argument, what: str) -> Iterator[Misuse]:
    value, place = given.value, place_of(given)
    if isinstance(value, Mapping) and value.items:
        yield Misuse(place, f"{what} takes a list of pairs, not a dict: {RAISES}; write `list({{…}}.items())`")
    if not isinstance(value, Sequence):
        return
    if any(isinstance(item, Text | Constant | Mapping) for item in value.items):
        yield Misuse(place, f"{what} takes a list of pairs `('from', 'to')`, and here is none: {RAISES}")
        return
    for item in value.items:
        if isinstance(item, Sequence) and item.complete and (item.kind != "tuple" or len(item.items) != 2):
            found = f"{kind_of(item)} of {len(item.items)}"
            yield Misuse(within(item, place), f"{what} takes pairs `('from', 'to')`, and this is {found}: {RAISES}")

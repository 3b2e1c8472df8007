"""The entry points of setup(entry_points=…): a dict of groups, or a text in the format of setup.cfg."""

from __future__ import annotations

from collections.abc import Iterator

from ...languages.python.evaluate.conversion import is_known
from ...languages.python.evaluate.values import Mapping, Sequence, Text, Unknown, Value
from ...lazy_regex import regex
from .entry_point import EntryPoint, parse_entry_point
from .setup_text import SetupText

GROUP = regex(r"\[(?P<name>[^\]]+)\]")


def from_value(path: str, value: Value) -> Iterator[EntryPoint | Unknown]:
    """Yield the entry points of an argument `entry_points`, and the parts that can't be evaluated."""
    if isinstance(value, Text):
        yield from from_ini(SetupText.of(path, value))
        return
    if not isinstance(value, Mapping):
        if not (is_known(value) and not getattr(value, "value", value)):
            yield value if isinstance(value, Unknown) else Unknown(value.span, "it can't be evaluated")
        return
    yield from value.rest
    for group, (_, entries) in value.items.items():
        yield from from_group(path, str(group), entries)


def from_group(path: str, group: str, entries: Value) -> Iterator[EntryPoint | Unknown]:
    """Yield the entries of a group: one for each line of a text, or of the texts in a list, nested or not."""
    if isinstance(entries, Text):
        yield from (parse_entry_point(group, line) for line in SetupText.of(path, entries).lines())
        return
    if not isinstance(entries, Sequence):
        yield entries if isinstance(entries, Unknown) else Unknown(entries.span, "it can't be evaluated")
        return
    for item, position in zip(entries.items, entries.places, strict=True):
        if isinstance(item, Text):
            yield from (parse_entry_point(group, line, entries, position) for line in SetupText.of(path, item).lines())
        else:
            yield from from_group(path, group, item)


def from_ini(setup_text: SetupText) -> Iterator[EntryPoint]:
    """Yield the entry points of a text with `[group]` lines."""
    group = ""
    for line in setup_text.lines():
        if (match := GROUP.fullmatch(line.text)) is not None:
            group = match["name"].strip()
        elif group:
            yield parse_entry_point(group, line)

"""Blocks of a parameter file of a plugin that no list in the same mapping names: `plugins: [voxel_layer]`.

Servers of Nav2 load what their lists name, and read a plugin's block only then.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence

from ...lazy_regex import regex
from ...light_dataclasses import dataclass

LINE = regex(r"(?P<indent>[ ]*)(?P<key>[\w./*-]+)[ ]*:(?:[ ]+(?P<value>.*)|[ ]*)")
LIST = regex(r"(?:\w+_)?plugins|filters")
ONE_LINE = regex(r"\[(?P<names>[^\[\]{}]*)\]\s*(?:#.*)?")


@dataclass(frozen=True, slots=True)
class Key:
    number: int
    """Of its line."""
    indent: int
    name: str
    value: str
    """The rest of its line."""


def is_unlisted(text: str, at: int) -> bool:
    """Return whether the block around an offset has sibling lists of plugins, and none of them names it.

    A list that is written in several lines may name it.
    """
    block, lists = block_and_lists(text, at)
    return bool(lists) and not is_in_list(block, lists)


def is_listed(text: str, at: int) -> bool:
    """Return whether a sibling list of the block around an offset names it, or may."""
    return is_in_list(*block_and_lists(text, at))


def is_in_list(block: str, lists: Iterable[str]) -> bool:
    return any(names is None or block in names_in(names["names"]) for names in map(ONE_LINE.fullmatch, lists))


def block_and_lists(text: str, at: int) -> tuple[str, list[str]]:
    """Return the name of the block whose `plugin` is at an offset, and the values of its sibling lists of plugins."""
    own, block, *_ = [*ancestors(text, at), None, None]
    if own is None or own.name != "plugin" or block is None:
        return "", []
    return block.name, [each.value for each in siblings(text, block) if LIST.fullmatch(each.name)]


def ancestors(text: str, at: int) -> list[Key]:
    """Return the key before an offset, and the keys of the mappings around it from the inside out."""
    lines = text[:at].splitlines()
    found: list[Key] = []
    for each in keys(lines, range(len(lines) - 1, -1, -1)):
        if not found or each.indent < found[-1].indent:
            found.append(each)
        if not each.indent:
            break
    return found


def siblings(text: str, key: Key) -> Iterator[Key]:
    """Yield the keys of the mapping that a key is in, but for itself; those above it first."""
    lines = text.splitlines()
    for numbers in (range(key.number - 1, -1, -1), range(key.number + 1, len(lines))):
        for each in keys(lines, numbers):
            if each.indent < key.indent:
                break
            if each.indent == key.indent:
                yield each


def keys(lines: Sequence[str], numbers: Iterable[int]) -> Iterator[Key]:
    """Yield the keys that begin the lines of some numbers."""
    for number in numbers:
        if (found := LINE.fullmatch(lines[number])) is not None:
            yield Key(number, len(found["indent"]), found["key"], found["value"] or "")


def names_in(text: str) -> set[str]:
    return {each.strip().strip("'\"") for each in text.split(",")}

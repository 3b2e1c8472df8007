"""Blocks of a parameter file that describe a plugin which no list beside them names: `plugins: [voxel_layer]`.

Servers of Nav2 load what their lists name, and read a plugin's block only then.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator

from ...lazy_regex import regex

LINE = regex(r"(?P<indent>[ ]*)(?P<key>[\w./-]+)[ ]*:(?:[ ]+(?P<value>.*)|[ ]*)")
LIST = regex(r"(?:\w+_)?plugins")
ONE_LINE = regex(r"\[(?P<names>[^\[\]{}]*)\]\s*(?:#.*)?")


def is_unlisted(text: str, at: int) -> bool:
    """Return whether the block that an offset is in has lists of plugins beside it, and none names it.

    A list that goes over several lines may name it.
    """
    above, below = keys(reversed(text[:at].splitlines())), keys(text[at:].splitlines()[1:])
    own = next(above, None)
    if own is None or own["key"] != "plugin":
        return False
    block = next((each for each in above if len(each["indent"]) < len(own["indent"])), None)
    if block is None:
        return False
    lists = [*lists_at(block["indent"], above), *lists_at(block["indent"], below)]
    named = [ONE_LINE.fullmatch(each) for each in lists]
    return bool(named) and all(each and block["key"] not in names_in(each["names"]) for each in named)


def keys(lines: Iterable[str]) -> Iterator[re.Match[str]]:
    return (found for line in lines if (found := LINE.fullmatch(line)) is not None)


def lists_at(indent: str, lines: Iterable[re.Match[str]]) -> Iterator[str]:
    """Yield the values of the lists of plugins of one mapping, from one of its keys on."""
    for each in lines:
        if len(each["indent"]) < len(indent):
            return
        if each["indent"] == indent and LIST.fullmatch(each["key"]):
            yield each["value"] or ""


def names_in(text: str) -> set[str]:
    return {each.strip().strip("'\"") for each in text.split(",")}

"""Patterns in which a name stands.

`%NAME%` is the name as a whole word, `%PART%` the name before what the pattern says, `%WORD%` another word.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from functools import cache

from ..source import Span

Affixes = tuple[str, str]
"""What stands before and behind the name in a longer one that follows it."""
ALONE: tuple[Affixes, ...] = (("", ""),)


@cache
def pattern(template: str, name: str, affixes: Affixes = ALONE[0]) -> re.Pattern[str]:
    """Return a pattern with a group `name`; with affixes, it stands for the name in the longer one."""
    word = re.escape(name)
    part = f"{re.escape(affixes[0])}(?P<name>{word}){re.escape(affixes[1])}"
    whole = rf"(?<![\w-]){part}(?![\w-])"
    text = template.replace("%NAME%", whole).replace("%PART%", part).replace("%WORD%", word)
    return re.compile(text, re.MULTILINE)


def found(templates: Iterable[str], text: str, name: str, around: Iterable[Affixes] = ALONE) -> Iterator[Span]:
    """Yield the places of a name in a text that one of the patterns fits, within each of the longer names."""
    for affixes in around:
        for template in templates:
            for match in pattern(template, name, affixes).finditer(text):
                yield Span(*match.span("name"))


def words(text: str, name: str) -> Iterator[Span]:
    """Yield the places of a name that a plain search for the word finds."""
    for match in re.finditer(rf"(?<!\w){re.escape(name)}(?!\w)", text):
        yield Span(*match.span())

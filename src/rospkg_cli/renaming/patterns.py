"""Patterns in which a name stands.

`%NAME%` is the name as a whole word, `%PART%` the name before what the pattern says, `%WORD%` one that is not meant.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from functools import cache

from ..source import Span


@cache
def pattern(template: str, name: str) -> re.Pattern[str]:
    """Return a pattern with a group `name`."""
    word = re.escape(name)
    whole = rf"(?<![\w-])(?P<name>{word})(?![\w-])"
    text = template.replace("%NAME%", whole).replace("%PART%", f"(?P<name>{word})").replace("%WORD%", word)
    return re.compile(text, re.MULTILINE)


def found(templates: Iterable[str], text: str, name: str) -> Iterator[Span]:
    """Yield the places of a name in a text that one of the patterns fits."""
    for template in templates:
        for match in pattern(template, name).finditer(text):
            yield Span(*match.span("name"))


def words(text: str, name: str) -> Iterator[Span]:
    """Yield the places of a name that a plain search for the word finds."""
    for match in re.finditer(rf"(?<!\w){re.escape(name)}(?!\w)", text):
        yield Span(*match.span())

"""Values of CMake variables: lists of words, each with its position; UNKNOWN stands in for unknown parts.

A text is an ordinary string with a few private characters in it, none of which a CMake file can hold.
"""

from __future__ import annotations

from collections.abc import Sequence

from ...light_dataclasses import dataclass, replace
from ...source import Span

UNKNOWN = "\0"
"""An unknown part of a text. A word that consists of it alone may be any number of words."""
SOURCE = "/\1source"
"""The folder of the package."""
BINARY = "/\1binary"
"""The build folder."""
PREFIX = "/\1prefix"
"""The install prefix."""
MAX_TEXT = 100_000
MAX_WORDS = 5_000


@dataclass(frozen=True, slots=True)
class Word:
    text: str
    path: str
    """The file of the argument."""
    span: Span
    """The argument that it comes from, with its quotes."""
    maybe: bool = False
    """It exists only under a condition that can't be evaluated."""
    quoted: bool = False

    @property
    def is_known(self) -> bool:
        """Whether the text is known: no unknown part, no generator expression."""
        return UNKNOWN not in self.text and "$<" not in self.text


Value = tuple[Word, ...]


def cost(words: Sequence[Word]) -> int:
    """Return the cost of reading some words: one for each, and one for every sixteen characters."""
    return len(words) + (sum(len(word.text) for word in words) >> 4)


def limited(value: Value) -> Value:
    """Return a list; UNKNOWN where it is too long to be kept."""
    return value if len(value) <= MAX_WORDS else (replace(value[0], text=UNKNOWN, maybe=False),)


def texts(value: Value) -> list[str]:
    return [word.text for word in value]

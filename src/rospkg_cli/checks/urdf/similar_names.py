"""Names of links and joints that are nearly the same: misspelled ones, and siblings such as `wheel_l` and `wheel_r`."""

from __future__ import annotations

import re
from collections.abc import Iterable

from ...suggest import near_names

WORD = re.compile(r"[_\W]+")
LONG = 6
"""The length from which two letters of a word may be wrong."""


def only_near(name: str, names: Iterable[str]) -> str | None:
    """Return the one name that differs in one letter, or in two letters of long words; None for siblings."""
    close = near_names(name, names, 1)
    found = close or near_names(name, names)
    if len(found) != 1 or "@" in name or are_siblings(name, found[0]):
        return None
    words = [word for word in WORD.split(name) if word not in WORD.split(found[0])]
    return found[0] if close or all(len(word) >= LONG for word in words) else None


def are_siblings(a: str, b: str) -> bool:
    """Return whether two names differ only in numbers or in words of one or two letters: `wheel_l`, `wheel_r`."""
    words = WORD.split(a), WORD.split(b)
    if len(words[0]) != len(words[1]):
        return False
    different = [pair for pair in zip(*words, strict=True) if pair[0] != pair[1]]
    return all((is_mark(one) and is_mark(other)) or numberless(one) == numberless(other) for one, other in different)


def is_mark(word: str) -> bool:
    """Return whether a word is as short as those for a side or a number: `l`, `fr`, `2`."""
    return len(word) <= 2


def numberless(word: str) -> str:
    return re.sub(r"\d+", "0", word)

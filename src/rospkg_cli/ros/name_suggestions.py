"""Suggestions for unknown names: the one package or key with a similar name."""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from itertools import takewhile

from ..lazy_regex import regex
from ..suggest import distance
from .aliases import NOTHING_NEEDED, key_for_apt, key_for_pip
from .distros import Targets
from .names import Names
from .read_table import rows

SEPARATOR = regex(r"[-_.]")
MAX_TYPOS = 2
"""More typos than these make another name."""
MAX_PART = 3
"""Letters at one end of a word that make another one of it: `turtlelib` is no `turtlesim`."""
LONG_REST = 6
"""How many letters two names must share in addition to a short word, so that one is a typo of the other."""


def suggested_name(name: str, names: Names, targets: Targets) -> str | None:
    """Return the only similar name that a target has; None where there is none, or where there are several."""
    for group in candidate_groups(name, names):
        there = [
            each for each in dict.fromkeys(group) if each != name and any(names.resolves(each, one) for one in targets)
        ]
        if there:
            return there[0] if len(there) == 1 else None
    return None


def candidate_groups(name: str, names: Names) -> Iterable[list[str]]:
    """Yield groups of similar names, the most certain first."""
    bare = re.sub(r"^python3?-|-pip$", "", name)
    for found in (key_for_apt(name, names), key_for_pip(name, names), key_for_pip(bare, names)):
        yield [found] if found else []
    yield [key for cmake, keys in rows("cmake.txt").items() if cmake.lower() == name for key in plain_names(keys)[:1]]
    everything = [each for each in names.all() if each != name]
    yield [each for each in everything if letters(each) == letters(name)]
    yield from names_by_typos(name, everything)


def plain_names(keys: Iterable[str]) -> list[str]:
    """Return those of a row that are names, not patterns."""
    return [key for key in keys if key != NOTHING_NEEDED and "*" not in key]


def letters(name: str) -> str:
    """Return what is left without capitals, dashes and underscores."""
    return SEPARATOR.sub("", name.lower())


def names_by_typos(name: str, others: Iterable[str], most: int = MAX_TYPOS) -> list[list[str]]:
    """Return the names that differ by typos in single words: those with the fewest first.

    A number is never taken for another: those are generations, and each is a thing of its own.
    """
    words, numbers = SEPARATOR.split(name), digits(name)
    found: dict[int, list[str]] = {}
    for each in others:
        if abs(len(each) - len(name)) > most:
            continue
        have = SEPARATOR.split(each)
        if len(have) != len(words) or (numbers and digits(each) not in ([], numbers)):
            continue
        pairs = list(zip(words, have, strict=True))
        far = 1 if has_short_slip(pairs) else sum(typos_between(word, other) for word, other in pairs)
        if 0 < far <= most:
            found.setdefault(far, []).append(each)
    return [found[far] for far in sorted(found)]


def has_short_slip(pairs: Sequence[tuple[str, str]]) -> bool:
    """Return whether two names differ by letters swapped, lost or doubled in one short word: `sensor_mgs`."""
    different = [(word, other) for word, other in pairs if word != other]
    if len(different) != 1 or sum(len(word) for word, other in pairs if word == other) < LONG_REST:
        return False
    ((word, other),) = different
    is_kept = sorted(word) == sorted(other) or len(word) != len(other)
    return is_kept and min(len(word), len(other)) > 1 and distance(word, other, 1) == 1


def typos_between(word: str, other: str) -> int:
    """Return by how many letters two words differ; more than MAX_TYPOS where that is no typo, as in a short word."""
    if word == other:
        return 0
    short, far = min(len(word), len(other)), distance(word, other, MAX_TYPOS)
    is_swap, is_plural = sorted(word) == sorted(other), f"{word}s" == other or word == f"{other}s"
    kept = far == 1 and (short > 4 or (short > 3 and (is_swap or len(word) != len(other))) or (short > 2 and is_plural))
    is_long = far == 2 and short > 8 and not has_other_part(word, other)
    return far if kept or is_long else MAX_TYPOS + 1


def has_other_part(word: str, other: str) -> bool:
    """Return whether other letters begin or end two words: no slip of the fingers, which loses or swaps some."""
    start = same_start(word, other)
    word, other = word[start:], other[start:]
    end = same_start(word[::-1], other[::-1])
    parts = (word[: len(word) - end], other[: len(other) - end])
    is_short = all(parts) and max(map(len, parts)) <= MAX_PART
    return is_short and (start == 0 or end == 0) and sorted(parts[0]) != sorted(parts[1])


def same_start(word: str, other: str) -> int:
    """Return how many letters two words have in common from their first one on."""
    return sum(1 for _ in takewhile(lambda pair: pair[0] == pair[1], zip(word, other, strict=False)))


def digits(name: str) -> list[str]:
    return re.findall(r"\d+", name)

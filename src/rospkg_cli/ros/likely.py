"""What is meant by a name that nobody has: the one package or key that is called nearly so."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterable

from ..suggest import distance
from .aliases import NOTHING_NEEDED, key_for_apt, key_for_pip
from .distros import Targets
from .names import Names
from .table import rows


def likely(name: str, names: Names, targets: Targets) -> str | None:
    """Return what is meant by an unknown name, of what a target has; None where nothing or several things may be."""
    for group in groups(name, names):
        there = [
            each for each in dict.fromkeys(group) if each != name and any(names.resolves(each, one) for one in targets)
        ]
        if there:
            return there[0] if len(there) == 1 else None
    return None


def groups(name: str, names: Names) -> Iterable[list[str]]:
    """Yield the names that may be meant, the surest first."""
    bare = re.sub(r"^python3?-|-pip$", "", name)
    for found in (key_for_apt(name, names), key_for_pip(name, names), key_for_pip(bare, names)):
        yield [found] if found else []
    yield [key for cmake, keys in rows("cmake.txt").items() if cmake.lower() == name for key in plain(keys)[:1]]
    everything = [each for each in names.all() if each != name]
    yield [each for each in everything if letters(each) == letters(name)]
    yield from by_distance(name, everything)


def plain(keys: Iterable[str]) -> list[str]:
    """Return those of a row that are names, not patterns."""
    return [key for key in keys if key != NOTHING_NEEDED and "*" not in key]


def letters(name: str) -> str:
    """Return what is left without capitals, dashes and underscores."""
    return re.sub(r"[-_.]", "", name.lower())


def by_distance(name: str, others: Iterable[str]) -> list[list[str]]:
    """Return the names that are one edit away, and those that are two; short names allow fewer.

    A number is never taken for another: those are generations, and each is a thing of its own.
    """
    limit = min(2, max(1, len(name) // 5))
    have, numbers = Counter(name), digits(name)
    found: dict[int, list[str]] = {}
    for each in others:
        if abs(len(each) - len(name)) <= limit and sum((have - Counter(each)).values()) <= limit:
            if numbers and digits(each) and digits(each) != numbers:
                continue
            found.setdefault(distance(name, each, limit), []).append(each)
    return [found.get(far, []) for far in range(1, limit + 1)]


def digits(name: str) -> list[str]:
    return re.findall(r"\d+", name)

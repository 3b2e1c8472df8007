"""Suggest the one name that is similar to a misspelt one."""

from __future__ import annotations

from collections.abc import Iterable
from difflib import SequenceMatcher

LONGEST = 200
"""Characters; a longer word is not a misspelt name, and comparing it is slow."""


def distance(a: str, b: str, limit: int = 3) -> int:
    """Return the number of edits (insert, delete, replace, swap) between two words, or limit + 1."""
    if abs(len(a) - len(b)) > limit:
        return limit + 1
    before: list[int] = []
    row = list(range(len(b) + 1))
    for i, char in enumerate(a, 1):
        before, last, row = row, before, [i]
        for j, other in enumerate(b, 1):
            cost = min(row[j - 1] + 1, before[j] + 1, before[j - 1] + (char != other))
            if i > 1 and j > 1 and char == b[j - 2] and a[i - 2] == other:
                cost = min(cost, last[j - 2] + 1)
            row.append(cost)
        if min(row) > limit:
            return limit + 1
    return min(row[-1], limit + 1)


def near_names(word: str, names: Iterable[str], limit: int = 2) -> list[str]:
    """Return the names within a distance, nearest first; short words allow fewer edits."""
    limit = min(limit, max(1, len(word) // 3))
    found = sorted((distance(word, name, limit), name) for name in set(names) if name != word)
    return [name for far, name in found if far <= limit]


def nearest(word: str, names: Iterable[str], limit: int = 2) -> str | None:
    """Return the near name if there is exactly one, else one that shares most of its letters, else None."""
    if len(word) > LONGEST:
        return None
    names = sorted(set(names) - {word})
    found = near_names(word, names, limit)
    if len(found) == 1:
        return found[0]
    if not found:
        alike = [name for name in names if SequenceMatcher(None, word, name).ratio() >= 0.75]
        return alike[0] if len(alike) == 1 else None
    return None


def did_you_mean(word: str, names: Iterable[str]) -> str:
    """Return ` (did you mean `x`?)`, or nothing."""
    found = nearest(word, names)
    return f" (did you mean `{found}`?)" if found else ""

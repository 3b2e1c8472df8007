"""Loops that will not end: after some rounds nothing changes any more, and the steps that are left would be wasted."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import count

from .conversion import is_equal
from .limits import MAX_COST, spend
from .values import Mapping, Namespace, Sequence, Unknown, Value

ENDLESS = 64
"""Rounds of a `while` after which it is looked at."""

Snapshot = dict[str, tuple[Value, int]]
"""Each name with its value, and how much that holds."""


def rounds_of(scope: Namespace) -> Iterator[int]:
    """Count the rounds of a loop; raises LimitError after one that left every name as it was."""
    before: Snapshot = {}
    for number in count():
        if number >= ENDLESS:
            after = snapshot(scope)
            if number > ENDLESS and has_stood_still(before, after):
                spend(MAX_COST + 1)
            before = after
        yield number


def snapshot(scope: Namespace) -> Snapshot:
    return {
        name: (value, len(value.items) if isinstance(value, Sequence | Mapping) else 0)
        for name, value in scope.names.items()
    }


def has_stood_still(before: Snapshot, after: Snapshot) -> bool:
    return before.keys() == after.keys() and all(
        before[name][1] == after[name][1] and is_same(before[name][0], after[name][0]) for name in after
    )


def is_same(a: Value, b: Value) -> bool:
    """Return whether two values are one, are equal, or are unknown at the same place."""
    if isinstance(a, Unknown) and isinstance(b, Unknown):
        return a.span == b.span
    return is_equal(a, b)

"""Few combinations in which every two values of every two factors meet."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from itertools import combinations, product
from typing import Any

Pair = tuple[tuple[str, Any], tuple[str, Any]]


def pairwise(factors: Mapping[str, Sequence[Any]]) -> list[dict[str, Any]]:
    """Return the combinations; the same factors give the same ones in the same order."""
    missing: dict[Pair, None] = {
        ((one, a), (other, b)): None
        for one, other in combinations(factors, 2)
        for a, b in product(factors[one], factors[other])
    }
    found = []
    while missing:
        row = dict(next(iter(missing)))
        for name in (name for name in factors if name not in row):
            row[name] = max(factors[name], key=lambda value: sum(pair in missing for pair in met(row, name, value)))
        row = {name: row[name] for name in factors}
        for pair in combinations(row.items(), 2):
            missing.pop(pair, None)
        found.append(row)
    return found


def met(row: Mapping[str, Any], name: str, value: Any) -> list[Pair]:
    """Return the pairs that a value would make with those of a row, in either order."""
    pairs = [((key, known), (name, value)) for key, known in row.items()]
    return pairs + [(second, first) for first, second in pairs]

"""The version limits of a dependency as a range."""

from __future__ import annotations

from collections.abc import Mapping

LOWER = {"version_gt": False, "version_gte": True, "version_eq": True}
UPPER = {"version_lt": False, "version_lte": True, "version_eq": True}


def is_empty(limits: Mapping[str, str]) -> bool:
    """Return whether no version meets all limits, given by attribute name; `1` and `1.2` mean `1.0.0` and `1.2.0`."""
    lowest = [(numbers(limits[name]), within) for name, within in LOWER.items() if name in limits]
    highest = [(numbers(limits[name]), within) for name, within in UPPER.items() if name in limits]
    return any(low > high or (low == high and not (a and b)) for low, a in lowest for high, b in highest)


def numbers(version: str) -> tuple[int, ...]:
    found = tuple(map(int, version.split(".")))
    return found + (0,) * (3 - len(found))

"""Whether a name of a target, package or variable is a slip of another one: by its letters, digits and words."""

from __future__ import annotations

from functools import lru_cache

from ...suggest import distance, near_names

LONG, LONG_WORD = 8, 4
"""Letters of a name, and of a word in it, from which it is a slip of another one, whatever else is unknown."""

LEAST = 5
"""Letters from which a name that is one letter off another one is a slip of it."""


def nearest(text: str, names: frozenset[str] | set[str], limit: int) -> str | None:
    """Return the nearest name with the same digits: `Eigen` may be there along with `Eigen3`."""
    own = digits(text)
    near = near_names(text, (name for name in names if digits(name) == own), limit)
    return near[0] if near else None


def is_clear_slip(text: str, near: str) -> bool:
    """Return whether a long name is a slip of another one, whatever is not known."""
    return len(text) >= LONG and differ_in_long_words(text, near)


def is_likely_slip(text: str, near: str) -> bool:
    """Return whether a name is one letter off another one, or is a clear slip of it; short names have neighbours."""
    is_near = len(text) >= LEAST and distance(text, near, 1) <= 1
    return is_near or are_swapped(text, near) or is_clear_slip(text, near)


def are_swapped(text: str, near: str) -> bool:
    """Return whether only two letters stand in the other order: no two things have such names."""
    return sorted(text) == sorted(near) and distance(text, near, 1) == 1


def differ_in_long_words(text: str, near: str) -> bool:
    """Return whether two names differ in words of some letters: `arm_x` and `arm_y` are two things."""
    alike = zip(text.split("_"), near.split("_"), strict=False)
    return all(a == b or min(len(a), len(b)) >= LONG_WORD for a, b in alike)


@lru_cache(maxsize=10_000)
def digits(text: str) -> str:
    """Return the digits of a name: `v1` and `v2` are two things, and no slips of each other."""
    return "".join(filter(str.isdecimal, text))

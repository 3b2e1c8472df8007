"""What a variable holds after branches of which it is unknown which one is taken."""

from __future__ import annotations

from collections.abc import Sequence

from ...light_dataclasses import replace
from .values import UNKNOWN, Value, texts


def merge_branches(values: Sequence[Value]) -> Value:
    """Return what a variable holds after branches that ended with these values.

    Elements that only some branches have become `maybe`; UNKNOWN where no value contains all the others.
    """
    first = values[0]
    if all(texts(value) == texts(first) for value in values):
        return next((value for value in values if any(word.maybe for word in value)), first)
    longest = max(values, key=len)
    if not all(is_within(texts(value), texts(longest)) for value in values):
        return (replace(longest[0], text=UNKNOWN, maybe=False),)
    common = frozenset(range(len(longest))).intersection(*(certain_elements(value, longest) for value in values))
    return tuple(word if at in common else replace(word, maybe=True) for at, word in enumerate(longest))


def certain_elements(shorter: Value, longer: Value) -> frozenset[int]:
    """Return which elements of a list are certainly those of another, which is within it."""
    rest = enumerate(longer)
    found = ((next(at for at, there in rest if there.text == word.text), word) for word in shorter)
    return frozenset(at for at, word in found if not word.maybe)


def is_within(shorter: Sequence[str], longer: Sequence[str]) -> bool:
    """Return whether the one is what is left of the other when elements are taken out."""
    rest = iter(longer)
    return all(each in rest for each in shorter)

"""Faults of one cause in several launch files of a package, which are reported once, where they are worst."""

from __future__ import annotations

from collections.abc import Hashable, Iterable, Iterator
from typing import Generic, TypeVar

from ...light_dataclasses import dataclass
from ...source import Span
from ..fault import Level

WORST_FIRST: tuple[Level | None, ...] = (None, "error", "warning", "info")
T = TypeVar("T")


@dataclass(frozen=True, slots=True)
class CausedPlace(Generic[T]):
    """A place of a fault, its cause, and its level; None for the rule's own."""

    cause: Hashable
    level: Level | None
    path: str
    span: Span
    item: T

    @property
    def sort_key(self) -> tuple[int, str, int]:
        return WORST_FIRST.index(self.level), self.path, self.span.start


def reported_in(path: str, places: Iterable[CausedPlace[T]]) -> Iterator[list[CausedPlace[T]]]:
    """Yield the places of each cause whose worst place is in a file; among equals the first place counts.

    That place is the first of the list.
    """
    found: dict[Hashable, dict[tuple[str, Span], CausedPlace[T]]] = {}
    for place in sorted(places, key=lambda each: each.sort_key):
        found.setdefault(place.cause, {}).setdefault((place.path, place.span), place)
    for alike in map(list, map(dict.values, found.values())):
        if alike[0].path == path:
            yield alike

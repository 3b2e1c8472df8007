"""From the places that have one cause to the related ones of a hit at the first of them."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TypeVar

from ..checks.launch.one_cause import CausedPlace
from ..finding import AGAIN, Related, Severity

MILDER = f"{AGAIN}, with less harm"
T = TypeVar("T")


def other_places(places: Sequence[CausedPlace[T]]) -> tuple[Related, ...]:
    """Return all but the first; of one in another file, whether it is as bad as that."""
    first, *others = places
    milder = [each.path != first.path and each.level != first.level for each in others]
    said = (MILDER if each else AGAIN for each in milder)
    return tuple(Related(each.path, each.span, message) for each, message in zip(others, said, strict=True))


def level_of(places: Sequence[CausedPlace[T]]) -> Severity | None:
    """Return the level of the worst; None for the rule's own."""
    return Severity(places[0].level) if places[0].level else None

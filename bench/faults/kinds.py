"""The kinds of single faults: a function a kind, found by its name."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass

from bench.faults.fault import PutFault
from bench.faults.source_package import SourcePackage

Places = Callable[[SourcePackage], Iterator[PutFault]]


@dataclass(frozen=True)
class FaultKind:
    name: str
    family: str
    places: Places
    is_seen_outside: bool = False
    """Whether packages that use the faulty one suffer, so that the whole repository is linted."""
    excluded: str = ""
    """Why this kind is equivalent or unknowable; "": it counts."""


KINDS: dict[str, FaultKind] = {}


def kind(family: str, *, is_seen_outside: bool = False, excluded: str = "") -> Callable[[Places], Places]:
    """Register a function that yields every fault of its kind that a package offers; its name is the kind's."""

    def register(places: Places) -> Places:
        name = places.__name__.replace("_", "-")
        KINDS[name] = FaultKind(name, family, places, is_seen_outside, excluded)
        return places

    return register

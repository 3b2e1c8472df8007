"""What is added consists of parts: a file, an entry point, a dependency, each put in and taken out on its own."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from typing import Protocol

from ..change import ChangeError, NotUnderstoodError
from ..change.draft import Draft, same
from ..finding import Operation
from ..package.package import Package
from ..tree import TreeEntry

Operations = Sequence[Operation]


class Part(Protocol):
    """One thing that `add` puts into a package."""

    def add(self, package: Package) -> Operations:
        """Return what puts it in, nothing where it is there.

        Raises ChangeError, and NotUnderstoodError where the file is not understood.
        """

    def remove(self, package: Package) -> Iterator[Operations]:
        """Yield the ways to take it out, the likeliest first; nothing where it is not there, or serves others too."""


def put_in(draft: Draft, folder: str, parts: Iterable[Part]) -> None:
    """Put parts into a package, each after the one before it.

    Raises ChangeError; NotUnderstoodError reports of all files that are not understood at once.
    """
    failed: list[NotUnderstoodError] = []
    for part in parts:
        try:
            draft.apply(folder, part.add(draft.package(folder)))
        except NotUnderstoodError as error:
            failed.append(error)
    if failed:
        first = failed[0]
        first.details = tuple(line for error in failed for line in error.details)
        raise first


def take_out(draft: Draft, folder: str, parts: Sequence[Part]) -> bool:
    """Take parts out of a package, the last first; return whether putting them in again would bring all back.

    What was not the last of its kind comes back at another place.
    """
    is_all = True
    for part in reversed(parts):
        is_all &= take_one(draft, folder, part)
    return is_all


def take_one(draft: Draft, folder: str, part: Part) -> bool:
    """Take a part out in the way that `add` would undo to the byte, else to another order, else in the likeliest."""
    ways: list[tuple[int, Draft]] = []
    for operations in part.remove(draft.package(folder)):
        tried = draft.copy()
        try:
            tried.apply(folder, operations)
        except ValueError:  # two of the edits overlap: this way is none
            continue
        loss = loss_of(tried, draft, folder, part)
        ways.append((loss, tried))
        if loss == NOTHING:
            break
    if not ways:
        return True
    least, best = min(ways, key=lambda way: way[0])
    draft.put_all(best.changes)
    return least < SOME


NOTHING, ORDER, SOME = range(3)
"""What is lost by removing and adding again: nothing, the order of things, or more."""


def loss_of(taken: Draft, draft: Draft, folder: str, part: Part) -> int:
    """Return what is lost where a part is taken out of a draft and put in again."""
    again = taken.copy()
    try:
        again.apply(folder, part.add(again.package(folder)))
    except ChangeError:
        return SOME
    pairs = [(again.entry(path), draft.entry(path)) for path in again.changes.keys() | draft.changes.keys()]
    if all(same(one, other) for one, other in pairs):
        return NOTHING
    is_same_text = all(same(one, other) or sorted(data_of(one)) == sorted(data_of(other)) for one, other in pairs)
    return ORDER if is_same_text else SOME


def data_of(entry: TreeEntry | None) -> bytes:
    return entry.data if entry else b""

"""What is added consists of parts: a file, an entry point, a dependency, each put in and taken out on its own."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from typing import Protocol

from ..change import ChangeError, NotUnderstoodError
from ..change.draft import Draft, same
from ..finding import Operation
from ..package.package import Package

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

    Raises ChangeError; NotUnderstoodError tells of all files that are not understood at once.
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
    """Take parts out of a package, the last first; return whether putting them in again would give the same files."""
    exact = True
    for part in reversed(parts):
        exact &= take_one(draft, folder, part)
    return exact


def take_one(draft: Draft, folder: str, part: Part) -> bool:
    """Take a part out in the way that `add` would undo, else in the likeliest."""
    first: Draft | None = None
    for operations in part.remove(draft.package(folder)):
        tried = draft.copy()
        tried.apply(folder, operations)
        first = first or tried
        if comes_back(tried, draft, folder, part):
            draft.put_all(tried.changes)
            return True
    if first is not None:
        draft.put_all(first.changes)
        return False
    return True


def comes_back(taken: Draft, draft: Draft, folder: str, part: Part) -> bool:
    """Return whether a part that was taken out of a draft comes back as it was."""
    again = taken.copy()
    try:
        again.apply(folder, part.add(again.package(folder)))
    except ChangeError:
        return False
    paths = again.changes.keys() | draft.changes.keys()
    return all(same(again.entry(path), draft.entry(path)) for path in paths)

"""Packages in memory, changed step by step and read anew after each: nothing of it is on disk."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from ..engine.fixing.apply import Changes, Round, apply_round
from ..engine.fixing.overlay import Overlay
from ..files import PackageFiles
from ..finding import Fix, Operation
from ..light_dataclasses import dataclass, field
from ..package.package import Package
from ..tree import Tree, TreeEntry
from . import ChangeError


@dataclass
class Draft:
    """A tree with changes over it. Paths and folders are relative to the root of the tree."""

    base: Tree
    changes: Changes = field(default_factory=dict)
    """What was made of the files so far; None where one is gone."""
    _packages: dict[str, Package] = field(default_factory=dict, init=False, repr=False)

    @property
    def tree(self) -> Overlay:
        return Overlay(self.base, self.changes)

    def package(self, folder: str) -> Package:
        """Return the package in a folder as it is now; it is read again after each change."""
        if folder not in self._packages:
            self._packages[folder] = Package(PackageFiles(self.tree.sub(folder), folder, self.tree))
        return self._packages[folder]

    def apply(self, folder: str, operations: Sequence[Operation]) -> None:
        """Make operations whose paths are relative to a folder; raises ChangeError where a file can't take them.

        Raises ValueError where edits overlap.
        """
        if not operations:
            return
        tree = self.tree.sub(folder)
        together = Round()
        together.take(Fix("", tuple(operations)))
        try:
            made = apply_round(tree, together)
        except UnicodeError as error:
            path = operations[0].path
            raise ChangeError(f"`{path}` has an encoding that can't hold the new text: {error}") from error
        self.put({f"{folder}/{path}" if folder else path: entry for path, entry in made.items()})

    def put(self, made: Changes) -> None:
        """Take whole files as they are to be; a file that is as it was counts as no change."""
        for path, entry in made.items():
            if same(entry, entry_in(self.base, path)):
                self.changes.pop(path, None)
            else:
                self.changes[path] = entry
        self._packages.clear()

    def put_all(self, changes: Changes) -> None:
        """Take the changes of another draft of the same tree in the place of all that there are."""
        self.changes = dict(changes)
        self._packages.clear()

    def entry(self, path: str) -> TreeEntry | None:
        """Return a file as it is now; None where there is none."""
        return entry_in(self.tree, path)

    def copy(self) -> Draft:
        """Return a draft that may go another way."""
        return Draft(self.base, dict(self.changes))

    def created(self) -> Iterable[str]:
        """The paths that were not there before."""
        return (path for path, entry in self.changes.items() if entry and entry_in(self.base, path) is None)


def entry_in(tree: Tree, path: str) -> TreeEntry | None:
    """Return a file of a tree; None where there is none."""
    try:
        return tree.entry(path)
    except FileNotFoundError:
        return None


def same(one: TreeEntry | None, other: TreeEntry | None) -> bool:
    """Return whether two files have the same bytes and may both be executed or not."""
    if one is None or other is None:
        return one is other
    return one.data == other.data and one.is_executable == other.is_executable

"""A tree in which files and folders have other names than on disk: what it is after a move that is yet to come."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cached_property
from pathlib import PurePosixPath

from ..light_dataclasses import dataclass
from ..tree import Kind, Tree, TreeEntry


@dataclass
class MovedTree:
    """The files of a tree under new names; nothing is read before it is asked for."""

    base: Tree
    renamed: Mapping[str, str]
    """The path of a file or folder, as it was, to its new last part: {"src/a": "b"}, {"src/a/include/a": "b"}."""

    def moved(self, path: str) -> str:
        """Return the new path of an old one."""
        parts = path.split("/")
        heads = ("/".join(parts[: end + 1]) for end in range(len(parts)))
        return "/".join(self.renamed.get(head, part) for head, part in zip(heads, parts, strict=True))

    @cached_property
    def _places(self) -> dict[str, str]:
        """The old path of each new one."""
        return {self.moved(path): path for path in self.base.files()}

    def files(self) -> Mapping[str, Kind]:
        kinds = self.base.files()
        return {path: kinds[self._places[path]] for path in sorted(self._places)}

    def entry(self, path: str) -> TreeEntry:
        place = self._places.get(path)
        if place is not None:
            return self.base.entry(place)
        if self.moved(path) != path:
            raise FileNotFoundError(path)
        return self.base.entry(path)

    def sub(self, folder: str) -> Tree:
        if not folder:
            return self
        old = self.before(folder)
        prefix = f"{old}/"
        inner = {path[len(prefix) :]: name for path, name in self.renamed.items() if path.startswith(prefix)}
        return MovedTree(self.base.sub(old), inner) if inner else self.base.sub(old)

    def before(self, folder: str) -> str:
        """Return the old path of a folder that has a new one."""
        old = ""
        for part in PurePosixPath(folder).parts:
            here = f"{old}/" if old else ""
            names = (path for path, name in self.renamed.items() if name == part and path.rpartition("/")[0] == old)
            old = next(names, f"{here}{part}")
        return old

"""A tree with changes laid over it, so that fixes can be judged before anything is written."""

from __future__ import annotations

from collections.abc import Mapping

from ...light_dataclasses import dataclass, field
from ...tree import Kind, Tree, TreeEntry
from .apply import Changes


@dataclass
class Overlay:
    base: Tree
    changes: Changes = field(default_factory=dict)

    def files(self) -> Mapping[str, Kind]:
        found = {path: kind for path, kind in self.base.files().items() if path not in self.changes}
        found |= {path: entry.kind for path, entry in self.changes.items() if entry is not None}
        return dict(sorted(found.items()))

    def entry(self, path: str) -> TreeEntry:
        if path not in self.changes:
            return self.base.entry(path)
        found = self.changes[path]
        if found is None:
            raise FileNotFoundError(path)
        return found

    def sub(self, folder: str) -> Tree:
        if not folder:
            return self
        prefix = folder + "/"
        inner = {path[len(prefix) :]: e for path, e in self.changes.items() if path.startswith(prefix)}
        return Overlay(self.base.sub(folder), inner) if inner else self.base.sub(folder)

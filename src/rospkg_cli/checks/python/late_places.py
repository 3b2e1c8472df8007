"""Rule input: places of Python that run only after a call of `spin`, which Ctrl-C ends by an exception."""

from __future__ import annotations

import ast
from functools import cached_property

from ...languages.python.file import PythonFile
from ...languages.python.nodes import nodes_of_kind
from ...languages.python.stopped_places import StoppedPlaces
from ...light_dataclasses import dataclass
from ...source import Span
from .behind_spin import called_behind_spin, is_behind_spin, is_called_late
from .run_imports import RunImports


@dataclass(frozen=True)
class LatePlaces:
    run: RunImports

    def has(self, file: PythonFile, span: Span) -> bool:
        """Return whether a place runs only behind a `spin`."""
        if is_behind_spin(file, span) or is_called_late((each for _, each in self.run.files), file, span):
            return True
        if file.path not in self.behind_spins:
            self.behind_spins[file.path] = called_behind_spin(file, lambda name: self.is_taken(file, name))
        places = self.behind_spins[file.path]
        return places is not None and places.has(span.start)

    @cached_property
    def behind_spins(self) -> dict[str, StoppedPlaces | None]:
        return {}

    def is_taken(self, file: PythonFile, name: str) -> bool:
        """Return whether another file imports a name, or reads it of something."""
        return not self.taken.get(name, frozenset()) <= {file.path}

    @cached_property
    def taken(self) -> dict[str, set[str]]:
        """By each name that files import or read of something, the paths of these files."""
        found: dict[str, set[str]] = {}
        for _, file in self.run.files:
            names = {name for each in file.imports for name in each.names}
            for name in names.union(each.attr for each in nodes_of_kind(file.tree, ast.Attribute)):
                found.setdefault(name, set()).add(file.path)
        return found

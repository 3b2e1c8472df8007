"""Imports against declarations: what a package imports and does not declare."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from ...source import Span
from .declared import Declared
from .python import PythonUse
from .roles import Role
from .serving import serving_import


@dataclass(frozen=True, slots=True)
class Place:
    path: str
    span: Span
    module: str


@dataclass(frozen=True, slots=True)
class Missing:
    """A dependency that is used and not declared: the name to declare, and where it is imported."""

    name: str
    places: tuple[Place, ...]


@dataclass(frozen=True)
class Imported:
    """The imports of a package, and what it declares."""

    declared: Declared
    python: PythonUse

    def missing(self, *roles: Role) -> Iterator[Missing]:
        """Yield what files of these roles import without its being declared, in the order of the files."""
        if not self.declared.judged:
            return
        found: dict[str, list[Place]] = {}
        for file in self.python.files:
            if file.role in roles:
                for each in file.imports:
                    name = serving_import(self.declared, each)
                    if name:
                        found.setdefault(name, []).append(Place(file.path, each.span, each.module))
        for name, places in found.items():
            yield Missing(name, tuple(places))

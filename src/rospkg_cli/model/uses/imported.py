"""Imports against declarations: what a package imports and does not declare."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from ...ros.imports import may_serve
from ...source import Span
from ..python import Import
from .declared import Declared
from .python import PythonUse
from .roles import Role

GENERATED = frozenset({"msg", "srv", "action"})
"""Modules that only rosidl makes: whose import they are is a ROS package for certain."""


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
                    name = self.needed(each)
                    if name:
                        found.setdefault(name, []).append(Place(file.path, each.span, each.module))
        for name, places in found.items():
            yield Missing(name, tuple(places))

    def needed(self, what: Import) -> str | None:
        """Return what to declare for an import; None where nothing is missing or nobody can tell."""
        if what.optional or what.typing:
            return None
        names = self.serving(what)
        declared = self.declared
        if not names or declared.has(names) or any(may_serve(name, what.module) for name in declared.names):
            return None
        return names[0]

    def serving(self, what: Import) -> tuple[str, ...]:
        found = self.declared.workspace.serving(what.module)
        top, _, rest = what.module.partition(".")
        if not found and rest.partition(".")[0] in GENERATED and any(name[:1].isupper() for name in what.names):
            return (top,)
        return found

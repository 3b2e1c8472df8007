"""Imports against declarations: what a package imports and does not declare."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from ...ros.stands_for import IN_TESTS, brought
from ...source import Span
from .declared import Declared
from .python import PythonUse
from .roles import Role
from .serving import served_by, serving_import


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
    brings: tuple[str, ...] = ()
    """What is missing as well, and is there with this one."""


@dataclass(frozen=True)
class Imported:
    """The imports of a package, and what it declares."""

    declared: Declared
    python: PythonUse

    def missing(self) -> list[Missing]:
        """Return what installed modules and scripts import without its being declared, in the order of the files."""
        return [Missing(name, tuple(places)) for name, places in self.undeclared("run").items()]

    def missing_in_tests(self) -> list[Missing]:
        """Return what tests alone import without its being declared, but for what other things bring."""
        installed = self.undeclared("run")
        there = brought(self.declared.names, IN_TESTS)
        found = {name: p for name, p in self.undeclared("test").items() if name not in there and name not in installed}
        result = []
        for name, places in found.items():
            if name not in brought(found.keys() - {name}, IN_TESTS):
                brings = sorted(brought([name], IN_TESTS) & found.keys())
                result.append(Missing(name, tuple(places), tuple(brings)))
        return result

    def uses(self, role: Role) -> Iterator[tuple[Place, tuple[str, ...]]]:
        """Yield what files of a role import and can't do without, and what serves it."""
        for file in self.python.files:
            for each in file.imports if file.role == role else ():
                names = () if each.optional or each.typing else served_by(self.declared, each)
                if names:
                    yield Place(file.path, each.span, each.module), names

    def undeclared(self, role: Role) -> dict[str, list[Place]]:
        found: dict[str, list[Place]] = {}
        for file in self.python.files if self.declared.judged else ():
            for each in file.imports if file.role == role else ():
                name = serving_import(self.declared, each)
                if name:
                    found.setdefault(name, []).append(Place(file.path, each.span, each.module))
        return found

"""The modules that the entry points of a package import: at their start, and at any time."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cached_property

from ...light_dataclasses import dataclass
from ...package.setup.entry_point import EntryPoint
from ..python.ros1_import import ros1_import
from .module_exports import absolute
from .python_package import PythonPackage
from .replaced_imports import is_replaced


@dataclass(frozen=True)
class StartedImports:
    package: PythonPackage

    @cached_property
    def names(self) -> frozenset[str]:
        """The dotted names of all modules, and of the objects in them, that a start imports.

        Imports under a `try`, for typing or in a function are left out: a start need not fail there.
        """
        return self.all_from_entries(at_once=True)

    @cached_property
    def names_at_some_time(self) -> frozenset[str]:
        """The same names, and those imported in functions or under a `try` without a replacement."""
        return self.all_from_entries(at_once=False)

    def all_from_entries(self, *, at_once: bool) -> frozenset[str]:
        return frozenset[str]().union(*(self.from_entry(each, at_once=at_once) for each in self.entries))

    @property
    def entries(self) -> list[EntryPoint]:
        return [entry for entry in self.package.setup.entry_points if entry.module and not entry.fault]

    def starting(self, package: str) -> list[EntryPoint]:
        """Return the entry points whose start imports a Python package, or a module in it."""
        return [each for each in self.entries if is_among(package, self.from_entry(each, at_once=True))]

    def from_entry(self, entry: EntryPoint, *, at_once: bool) -> frozenset[str]:
        found: set[str] = set()
        waiting = [entry.module]
        while waiting:
            name = waiting.pop()
            if name and name not in found:
                found.add(name)
                waiting += [name.rpartition(".")[0], *self.imported_by(name, at_once=at_once)]
        return frozenset(found)

    def imported_by(self, module: str, *, at_once: bool) -> Iterator[str]:
        """Yield what a module of the package imports, as soon as it is imported itself or at some time."""
        path = self.package.on_disk.get(module, "")
        file = self.package.modules.at(path) if path else None
        ended = ros1_import(file.imports) if file is not None else None
        for each in file.imports if file is not None else ():
            if ended is not None and each.span.start > ended.span.start:
                return
            is_late = each.is_local or each.is_optional
            is_spared = each.is_optional and file is not None and is_replaced(file, each)
            if not (each.is_for_typing or is_spared or (at_once and is_late)):
                name = absolute(each, path, self.package.setup)
                yield from (name, *(f"{name}.{part}" for part in each.names))

    def reaches(self, package: str) -> bool:
        """Return whether a start imports a Python package, or a module in it."""
        return is_among(package, self.names)

    def may_reach(self, package: str) -> bool:
        """Return whether a program may import it at some time, or the package has no program."""
        return not self.package.setup.entry_points or is_among(package, self.names_at_some_time)


def is_among(package: str, names: frozenset[str]) -> bool:
    return any(name == package or name.startswith(f"{package}.") for name in names)

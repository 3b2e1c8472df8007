"""The modules that Python imports at the start of a package's entry points, before any of their functions is called."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cached_property

from ...light_dataclasses import dataclass
from .module_exports import absolute
from .python_package import PythonPackage


@dataclass(frozen=True)
class StartedImports:
    package: PythonPackage

    @cached_property
    def names(self) -> frozenset[str]:
        """The dotted names of all that is imported, modules and what is taken out of them alike.

        Nothing that is imported under a `try`, for typing or in a function: a start need not end there.
        """
        found: set[str] = set()
        waiting = [entry.module for entry in self.package.setup.entry_points if entry.module and not entry.fault]
        while waiting:
            name = waiting.pop()
            if name and name not in found:
                found.add(name)
                waiting += [name.rpartition(".")[0], *self.imported_by(name)]
        return frozenset(found)

    def imported_by(self, module: str) -> Iterator[str]:
        """Yield what a module of the package imports as soon as it is imported itself."""
        path = self.package.on_disk.get(module, "")
        file = self.package.modules.at(path) if path else None
        for each in file.imports if file is not None else ():
            if not (each.is_optional or each.is_for_typing or each.is_local):
                name = absolute(each, path, self.package.setup)
                yield from (name, *(f"{name}.{part}" for part in each.names))

    def reaches(self, package: str) -> bool:
        """Return whether a start imports a Python package, or a module in it."""
        return any(name == package or name.startswith(f"{package}.") for name in self.names)

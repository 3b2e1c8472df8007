"""Rule input: which of a package's own modules its Python files import, directly or through other modules."""

from __future__ import annotations

from functools import cached_property

from ...languages.python.file import PythonFile
from ...languages.python.imports import Import
from ...light_dataclasses import dataclass
from .installed_modules import InstalledModules
from .run_imports import RunImports


@dataclass(frozen=True)
class ModuleImports:
    installed: InstalledModules
    run: RunImports

    @cached_property
    def uses(self) -> dict[str, list[tuple[PythonFile, Import]]]:
        """By the dotted name of a module, each import of it with its file; one from the same folder counts, too."""
        found: dict[str, list[tuple[PythonFile, Import]]] = {}
        for _, file in self.run.files:
            folder = self.installed.names.get(file.path, "").rpartition(".")[0]
            for each in file.imports:
                in_folder = [f"{folder}.{each.module}"] if folder and not each.level else []
                for name in dict.fromkeys((*self.imported_by(each, file.path), *in_folder)):
                    found.setdefault(name, []).append((file, each))
        return found

    def imported_by(self, each: Import, path: str) -> list[str]:
        """Return the dotted names that an import of a file may load: the module, and each imported name as a module."""
        inner = self.installed.absolute(each, path)
        return [inner, *(f"{inner}.{name}" for name in each.names)]

    def imported_from(self, waiting: list[str], *, around: bool = False) -> frozenset[str]:
        """Return some modules and all that they import; with `around`, also the packages that these are in."""
        found: set[str] = set()
        while waiting:
            module = waiting.pop()
            source = self.installed.sources.get(module, "")
            file = self.run.modules.at(source) if source else None
            if module not in found and file is not None:
                found.add(module)
                waiting += [module.rpartition(".")[0]] if around and "." in module else []
                for each in file.imports:
                    waiting += self.imported_by(each, source)
        return frozenset(found)

    def imported_from_folder(self, programs: list[str]) -> set[str]:
        """Return some modules and those of the same folder that they import when they are run by their path."""
        found, waiting = set[str](), [*programs]
        while waiting:
            module = waiting.pop()
            source = self.installed.sources.get(module, "")
            file = self.run.modules.at(source) if source and module not in found else None
            if file is not None:
                found.add(module)
                package = module.rpartition(".")[0]
                waiting += [f"{package}.{each.module}" for each in file.imports if not each.level]
        return found

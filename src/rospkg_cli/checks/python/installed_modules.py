"""The Python modules that a package installs, by their dotted names, and what each of them offers."""

from __future__ import annotations

import posixpath
from functools import cached_property

from ...files import PackageFiles
from ...languages.python.imports import Import
from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...package.install_table import PYTHON, InstallTable
from ...package.python_modules import PythonModules
from ...package.read_install_table import module_name

MADE = regex(r"_.*|.*_pb2(?:_grpc)?|ui_.*|.*_(?:ui|rc)|version")
"""Names of modules that builds write."""

MAX_DEPTH = 10


@dataclass(frozen=True)
class InstalledModules:
    files: PackageFiles
    modules: PythonModules
    table: InstallTable

    @cached_property
    def sources(self) -> dict[str, str]:
        """The file of each installed module; "" of one that the build makes."""
        rows = (row for row in self.table.of("module") if row.destination.startswith(f"{PYTHON}/"))
        named = ((module_name(row.destination[len(PYTHON) + 1 :]), row.source) for row in rows)
        return {name: source for name, source in named if name}

    @cached_property
    def names(self) -> dict[str, str]:
        """The dotted name of each file that is installed as a module."""
        return {source: name for name, source in self.sources.items() if source}

    @cached_property
    def tops(self) -> frozenset[str]:
        return frozenset(name.partition(".")[0] for name in self.sources)

    def folder(self, package: str) -> str | None:
        """Return the folder of a Python package; None where that is unknown, or where it extends its path."""
        source = self.sources.get(package, "")
        if not source.endswith("__init__.py") or "__path__" in self.files.readable_text(source):
            return None
        return posixpath.dirname(source)

    def is_plain(self, module: str) -> bool:
        """Return whether a module is a file, in which no other can be."""
        source = self.sources.get(module, "")
        text = self.files.readable_text(source) if source else ""
        return bool(source) and not source.endswith("__init__.py") and "__path__" not in text

    def below(self, package: str) -> list[str]:
        """Return the last names of the modules in a package."""
        start = f"{package}."
        return [name[len(start) :] for name in self.sources if name.startswith(start) and "." not in name[len(start) :]]

    def missing(self, module: str) -> tuple[str, str] | None:
        """Return the package and the name in it at which importing a module ends; None where it may be there."""
        parts = module.split(".")
        for end in range(1, len(parts)):
            package, name = ".".join(parts[:end]), parts[end]
            if f"{package}.{name}" not in self.sources:
                return None if self.may_be_in(package, name) else (package, name)
        return None

    def may_be_in(self, package: str, name: str) -> bool:
        """Return whether a package may have a module: it is there and not installed, or a build makes it."""
        if self.is_plain(package):
            return False
        folder = self.folder(package)
        if folder is None or MADE.fullmatch(name):
            return True
        expected = self.files.absent.is_expected
        if expected(f"{folder}/{name}.py") or expected(f"{folder}/{name}/__init__.py"):
            return True
        inside = f"{folder}/{name}/"
        is_made = any(each.startswith(inside) for each in self.files.absent.empty_submodules)
        if is_made or f"{folder}/{name}" in self.files.folders:
            return True
        if any(path.startswith(f"{folder}/{name}.") for path in self.files.every):
            return True
        from .compiled_modules import is_compiled  # few imports are of what is not there

        return is_compiled(self.files, name)

    def offers(self, module: str, name: str, depth: int = 0) -> bool:
        """Return whether a module defines or imports a name at its top level, or may do so."""
        source = self.sources.get(module, "")
        file = self.modules.at(source) if source else None
        if file is None or depth > MAX_DEPTH or name in file.definitions:
            return True
        if file.has_dynamic_names or "sys.modules" in file.source.text:
            return True
        if f"{module}.{name}" in self.sources or self.may_be_in(module, name):
            return True
        for star in file.star_imports:
            inner = self.absolute(star, source)
            if inner not in self.sources or self.offers(inner, name, depth + 1):
                return True
        return False

    def absolute(self, each: Import, path: str) -> str:
        """Return the dotted name of what a file imports; "" where the file is no module, or the dots lead out."""
        if not each.level:
            return each.module
        package = self.names.get(path, "").split(".")
        package = package[: len(package) - each.level + path.endswith("__init__.py")]
        return ".".join([*package, *([each.module] if each.module else [])]) if package != [""] and package else ""

"""Python packages of a CMake package that a script or a launch file imports and that nothing installs."""

from __future__ import annotations

import posixpath
from collections.abc import Iterator, Mapping
from functools import cached_property

from ...languages.python.imports import Import
from ...light_dataclasses import dataclass
from ...package.cmake.cmake_package import CMakePackage
from ...package.cmake.referenced_paths import ReferencedPaths
from ...package.file_role import role_of
from ...package.install_table import PYTHON, InstalledFile, InstallTable
from ...package.python_modules import PythonModules
from ...source import Span
from ..reached_definitions import ReachedDefinitions
from .python_path_hooks import may_set_python_path
from .unmet_imports import UnmetImports


@dataclass(frozen=True)
class UninstalledPythonPackage:
    """A Python package that is imported and not installed, and where it is imported."""

    folder: str
    path: str
    span: Span
    module: str
    is_started: bool
    """Whether the file that imports it is an installed program or a launch file."""
    why_unmet: str = ""
    """Why nothing is known to reach the import."""


@dataclass(frozen=True)
class PythonPackages:
    package: CMakePackage
    table: InstallTable
    modules: PythonModules
    definitions: ReachedDefinitions | None = None

    @cached_property
    def unmet(self) -> UnmetImports:
        return UnmetImports(self.package.cmake.package_files, self.definitions)

    @cached_property
    def folders(self) -> Mapping[str, str]:
        """Name → folder of the Python packages right below the package; of that called like it in src/, too."""
        paths = self.package.cmake.package_files.paths
        found = {path.split("/")[0] for path in paths if path.count("/") == 1 and path.endswith("/__init__.py")}
        name = self.package.facts.name
        in_src = {name: f"src/{name}"} if f"src/{name}/__init__.py" in paths else {}
        return {**in_src, **{each: each for each in found}}

    @cached_property
    def installed(self) -> frozenset[str]:
        """The top-level names of the installed modules."""
        return frozenset(path.partition("/")[0].removesuffix(".py") for path, _ in self.table.below(PYTHON))

    def uninstalled(self) -> Iterator[UninstalledPythonPackage]:
        """Yield each Python package that an installed file imports and that is not installed, with who surely ends."""
        found: dict[str, UninstalledPythonPackage] = {}
        for each in sorted(self.importing(), key=lambda each: (each.why_unmet != "", not each.is_started)):
            found.setdefault(each.folder, each)
        yield from found.values()

    def importing(self) -> Iterator[UninstalledPythonPackage]:
        """Yield each import of such a package in an installed file."""
        cmake = self.package.cmake
        if not self.table.knows("module") or not cmake.is_complete or may_set_python_path(cmake):
            return
        if self.names_no_folder:
            return
        missing = self.folders.keys() - self.installed - self.found_by_scripts
        for row in self.table.rows:
            if row.what not in ("executable", "share") or not row.source.endswith(".py") or not missing:
                continue
            file = self.modules.at(row.source)
            if file is not None and "sys.path" in cmake.package_files.source(row.source).text:
                continue
            for each in file.imports if file is not None else ():
                name = each.module.partition(".")[0]
                if (
                    name in missing
                    and not (row.what == "share" and row.source.startswith(f"{self.folders[name]}/"))
                    and not each.level
                    and not (each.is_optional or each.is_for_typing)
                    and self.is_own(each)
                    and not self.is_next_to(row, name)
                    and file is not None
                ):
                    is_started = row.what == "executable" or role_of(row.source) == "launch"
                    why = self.unmet.why(file, each, row) or self.why_found(name)
                    yield UninstalledPythonPackage(name, row.source, each.span, each.module, is_started, why)

    def why_found(self, name: str) -> str:
        """Return why Python finds a Python package where its source lies; "" where no text says so."""
        from ..found_in_source import why_found  # what findings alone need

        return why_found(self.package.cmake.package_files, posixpath.dirname(self.folders[name]))

    def is_next_to(self, row: InstalledFile, name: str) -> bool:
        """Return whether a Python package is installed next to a file; or with it, next to a script that imports it."""
        here, inside = posixpath.dirname(row.destination), row.source.removeprefix(f"{self.folders[name]}/")
        above = row.destination.removesuffix(f"/{name}/{inside}")
        if inside != row.source and above != row.destination:
            return any(posixpath.dirname(other.destination) == above for other in self.table.rows)
        return any(other.destination.startswith(f"{here}/{name}/") for other in self.table.rows)

    @property
    def found_by_scripts(self) -> set[str]:
        """The top-level names that an installed script imports after it has changed where Python looks."""
        files = (self.modules.at(row.source) for row in self.table.rows if row.source.endswith(".py"))
        able = (file for file in files if file is not None and "sys.path" in file.source.text)
        return {each.module.partition(".")[0] for file in able for each in file.imports if not each.level}

    @cached_property
    def names_no_folder(self) -> bool:
        """Whether `ament_python_install_package()` is given a folder that is not there, which CMK102 reports."""
        missing = ReferencedPaths(self.package.cmake).missing()
        return any(each.call.name == "ament_python_install_package" for each in missing)

    def is_own(self, what: Import) -> bool:
        """Return whether an import refers to a module of the package, and not to one that rosidl generates."""
        files, path = self.package.cmake.package_files, what.module.replace(".", "/")
        if path == self.package.facts.name and not self.package.cmake.interface_targets:
            return True
        top, slash, below = path.partition("/")
        path = self.folders.get(top, top) + slash + below
        named = ([path] if slash else []) + [f"{path}/{name}" for name in what.names]
        return any(files.exists(f"{each}.py") or files.exists(f"{each}/__init__.py") for each in named)

"""Rule input: the imports of a package, and where Python finds the modules of the workspace (DEP109, DEP110)."""

from __future__ import annotations

from functools import cached_property

from ...files import PackageFiles
from ...languages.python.file import PythonFile
from ...languages.python.imports import Import
from ...light_dataclasses import dataclass
from ...package.cmake.cmake_project import CMake
from ...package.install_table import InstallTable
from ...package.package_facts import PackageFacts
from ...package.workspace import Workspace
from ...ros.imports import STANDARD
from ..python.installed_modules import InstalledModules
from ..python.run_imports import PATHS, RunImports
from ..reached_modules import ReachedModules
from ..reached_places import ReachedPlaces
from .pip_installs import PipInstalls, normalized

BUILDING = ("ext_modules", "cythonize", "cmdclass", "rust_extensions")
"""Words by which setup.py makes modules that are no Python files."""


@dataclass(frozen=True)
class OwnImports:
    """The imports of installed modules and of what runs next to them, and the modules of the workspace."""

    facts: PackageFacts
    workspace: Workspace
    files: PackageFiles
    run: RunImports
    table: InstallTable
    installed: InstalledModules
    reached: ReachedModules
    places: ReachedPlaces
    cmake: CMake | None = None

    @cached_property
    def may_be_made(self) -> bool:
        """Whether the build may make modules that have no file: it compiles or writes some, or is not all known."""
        if self.facts.build_type == "ament_python":
            return any(word in self.files.readable_text("setup.py") for word in BUILDING)
        if self.cmake is None or not self.cmake.is_complete or self.cmake.reads_unknown_files:
            return True
        from .module_makers import may_make_modules  # for packages of CMake alone

        return any(may_make_modules(call) for call in self.cmake.calls) or any(
            not source for source in self.installed.sources.values()
        )

    def changes_path(self, file: PythonFile) -> bool:
        """Return whether an import in a file may find a module that this package does not install."""
        return self.run.changes_path or any(word in file.source.text for word in PATHS)

    def has_all(self, each: Import, module: str) -> bool:
        """Return whether a module of the package exists and has all names that an import takes from it."""
        names = (name for name in each.names if name != "*")
        return module in self.installed.sources and all(self.installed.offers(module, name) for name in names)

    def offered(self, module: str) -> list[str]:
        """Return the names that a module may be asked for."""
        file = self.run.modules.at(self.installed.sources[module])
        return [*self.installed.below(module), *(file.definitions if file is not None else ())]

    def is_from_pip(self, top: str) -> bool:
        """Return whether the repository has pip install a distribution of that name."""
        return normalized(top) in PipInstalls(self.files).names

    def is_found(self, each: Import) -> bool:
        """Return whether Python may find an imported module outside of the importing file's folder."""
        top = each.module.partition(".")[0]
        own = top in self.installed.tops or top in STANDARD or self.files.exists(f"{top}.py")
        own = own or f"{top}.py" in self.beside_programs or self.is_beside_programs(each)
        return own or bool(self.workspace.providers_of(top)) or top in {each.name for each in self.facts.dependencies}

    def is_beside_programs(self, each: Import) -> bool:
        """Return whether an import finds a module in lib/<package>, the first folder where all programs look.

        A folder there needs no `__init__.py`, and has what was put into it alone.
        """
        path = each.module.replace(".", "/")
        is_file = not {f"{path}.py", f"{path}/__init__.py"}.isdisjoint(self.beside_programs)
        inner = (f"{path}/{name}" for name in each.names) if each.names and not is_file else (path,)
        return is_file or all(map(self.has_beside_programs, inner))

    def has_beside_programs(self, path: str) -> bool:
        beside = self.beside_programs
        return f"{path}.py" in beside or any(each.startswith(f"{path}/") for each in beside)

    @cached_property
    def beside_programs(self) -> frozenset[str]:
        """The paths of what is installed into lib/<package>, below that."""
        return frozenset(path for path, _ in self.table.below(f"lib/{self.facts.name}"))

"""Python imports that package.xml does not declare (DEP101, DEP102)."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from functools import cached_property
from typing import TYPE_CHECKING

from ...files import PackageFiles
from ...light_dataclasses import dataclass
from ...package.cmake.cmake_project import CMake
from ...package.file_role import Role
from ...package.python.python_imports import PackageImports
from ..python.ros1_import import ros1_import
from ..reached_modules import ReachedModules
from ..reached_places import ReachedPlaces
from ..unstarted_programs import UnstartedPrograms
from .declared_dependencies import DeclaredDependencies
from .import_provider import import_providers, undeclared_provider
from .import_use import ImportUse, UndeclaredImport
from .other_pythons import OtherPythons
from .pip_installs import PipInstalls
from .ros1_import_ends import Ros1ImportEnds

if TYPE_CHECKING:
    from .import_reach import ImportReach
    from .import_sources import ImportSources

BUILDERS = frozenset({"setuptools", "distutils", "pkg_resources", "wheel", "catkin_pkg"})
"""What runs setup.py, or colcon needs itself."""


@dataclass(frozen=True)
class ImportDependencies:
    """The imports of a package, and what it declares."""

    declared: DeclaredDependencies
    python: PackageImports
    files: PackageFiles
    reached: ReachedModules | None = None
    cmake: CMake | None = None
    places: ReachedPlaces | None = None
    programs: UnstartedPrograms | None = None
    pythons: OtherPythons | None = None

    @cached_property
    def pip(self) -> PipInstalls:
        return PipInstalls(self.files)

    @cached_property
    def sources(self) -> ImportSources:
        from .import_sources import ImportSources  # most packages declare what they import

        return ImportSources(self.declared, self.python, self.files, self.pip, self.pythons)

    @cached_property
    def ends(self) -> Ros1ImportEnds:
        return Ros1ImportEnds(self.declared, self.python, self.pip)

    @cached_property
    def reach(self) -> ImportReach:
        from .import_reach import ImportReach

        return ImportReach(
            self.declared, self.python, self.ends, self.reached, self.places, self.programs, self.pythons
        )

    def serving(self, missing: UndeclaredImport) -> tuple[str, ...]:
        """Return the names that provide what is missing: the one to declare, and others that would do."""
        return (missing.name, *self.declared.workspace.providers_of(missing.places[0].module))

    def missing(self) -> list[UndeclaredImport]:
        """Return what installed modules and scripts import undeclared, in the order of the files."""
        return self.with_bringers(self.undeclared("run"), runs=True)

    def with_bringers(self, missing: Mapping[str, list[ImportUse]], *, runs: bool) -> list[UndeclaredImport]:
        """Return what is missing, each with the declared dependency, or the other missing one, that brings it."""
        bringers = self.declared.bringers(missing, runs=runs)
        return [
            UndeclaredImport(name, self.reach.in_use_first(p), (), bringers.get(name)) for name, p in missing.items()
        ]

    def missing_in_setup(self) -> list[UndeclaredImport]:
        """Return what setup.py itself imports undeclared, but for the tools that run it."""
        found: dict[str, list[ImportUse]] = {}
        python = self.declared.facts.build_type == "ament_python"
        for file in self.python.files if python else ():
            for each in file.imports if file.path == "setup.py" else ():
                name = (
                    undeclared_provider(self.declared, each) if each.module.partition(".")[0] not in BUILDERS else None
                )
                if name:
                    found.setdefault(name, []).append(ImportUse(file.path, each.span, each.module))
        return self.with_bringers(found, runs=False)

    def uses(self, role: Role) -> Iterator[tuple[ImportUse, tuple[str, ...]]]:
        """Yield the imports of files of a role that are not optional, with their providers."""
        for file in self.python.files:
            for each in file.imports if file.role == role else ():
                names = () if each.is_optional or each.is_for_typing else import_providers(self.declared, each)
                if names:
                    yield ImportUse(file.path, each.span, each.module), names

    def undeclared(self, role: Role) -> dict[str, list[ImportUse]]:
        """Return what files of a role import undeclared, with the places; files that import ROS 1 are left out."""
        found: dict[str, list[ImportUse]] = {}
        for file in self.python.files if self.declared.is_checked else ():
            for each in file.imports if file.role == role and ros1_import(file.imports) is None else ():
                name = undeclared_provider(self.declared, each)
                if name:
                    found.setdefault(name, []).append(ImportUse(file.path, each.span, each.module))
        return found

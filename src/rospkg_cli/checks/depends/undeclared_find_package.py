"""Required `find_package()` calls for packages that package.xml does not declare (DEP104)."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from functools import cached_property

from ...light_dataclasses import dataclass
from ...package.cmake.cmake_project import CMake
from ...package.cmake.find_package import FoundPackage
from ...package.interfaces.interface_file import InterfaceFile
from ...ros.implied_dependencies import IN_CMAKE, implied_by
from ...suggest import near_names
from .brought_dependencies import Bringer
from .declared_dependencies import DeclaredDependencies
from .find_package_providers import FindPackageProviders
from .needed_find_packages import NeededFindPackages
from .own_places import looks_elsewhere


@dataclass(frozen=True, slots=True)
class UndeclaredFindPackage:
    """A package that CMake finds, and the names that provide it; the first is the one to recommend."""

    found: FoundPackage
    names: tuple[str, ...]
    bringer: Bringer | None
    """The declared dependency that it comes with, or may come with; None where none brings it."""
    is_installable: bool
    """Whether rosdep installs something for it on a supported distribution."""


@dataclass(frozen=True)
class FindPackageDependencies:
    """The packages that CMake looks for, and what package.xml declares."""

    declared: DeclaredDependencies
    cmake: CMake
    interfaces: tuple[InterfaceFile, ...] = ()

    @cached_property
    def provided(self) -> FindPackageProviders:
        return FindPackageProviders(self.declared)

    @cached_property
    def needed(self) -> NeededFindPackages:
        return NeededFindPackages(self.cmake, self.interfaces)

    def missing(self) -> tuple[UndeclaredFindPackage, ...]:
        """Return what CMake can't do without and package.xml does not declare, each once; tests come last."""
        return self._missing

    @cached_property
    def _missing(self) -> tuple[UndeclaredFindPackage, ...]:
        return tuple(self.undeclared())

    def undeclared(self) -> Iterator[UndeclaredFindPackage]:
        """Yield what `missing` returns."""
        if not self.declared.is_checked:
            return
        there = implied_by(self.declared.names, IN_CMAKE)
        seen: set[str] = set()
        for found in sorted(self.cmake.packages, key=lambda each: each.call.testing):
            if found.name in seen or not self.needed.has(found):
                continue
            seen.add(found.name)
            names = (*self.provided.of_components(found), *self.provided.of(found.name))
            if names and not self.declared.has(names) and not there.intersection(names):
                yield UndeclaredFindPackage(
                    found, names, self.bringer(found.name, names), self.provided.is_installable(names[0])
                )

    def is_declared_alike(self, name: str) -> bool:
        """Return whether package.xml declares a name, one that provides it, or a similar one."""
        declared = self.declared.names
        return self.declared.has([name]) or bool(near_names(name, declared) or self.provided.matching(name, declared))

    def needed_providers(self, found: FoundPackage) -> tuple[str, ...]:
        """Return the names that provide a package without which the configuration certainly fails; () for others."""
        return self.provided.of(found.name) if self.needed.has(found) else ()

    def bringer(self, name: str, names: tuple[str, ...]) -> Bringer | None:
        """Return the declared dependency that brings a package of CMake, or may do so, by any of its names."""
        there = self.declared.brings.brought_to_build
        brought = (*there.certain, *there.perhaps)
        alike = (*self.provided.matching(name, brought), *self.provided.matching(name, brought, of_run_time=True))
        return self.declared.bringer((*names, *alike), runs=False)

    def is_elsewhere(self, found: FoundPackage, names: Iterable[str]) -> bool:
        """Return whether it is a library of the system that CMake looks for in a folder which the package names."""
        index = self.declared.workspace.index
        is_library = any(index.is_key(each) and not index.is_package(each) for each in names)
        return is_library and looks_elsewhere(found, self.cmake)

    def for_run_time(self, found: FoundPackage) -> str:
        """Return the declared key of the library that comes without its headers; "" for none."""
        return next(iter(self.provided.matching(found.name, sorted(self.declared.names), of_run_time=True)), "")

"""C++ includes of packages that package.xml does not declare (DEP105)."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from functools import cached_property
from typing import TYPE_CHECKING

from ...files import PackageFiles
from ...languages.cpp.file import CppFile
from ...light_dataclasses import dataclass
from ...package.cmake.cmake_project import CMake
from ...package.install_table import InstallTable
from ...package.interfaces.interface_file import InterfaceFile
from ...ros.implied_dependencies import IN_SOURCES, implied_by
from .brought_dependencies import Bringer, brought_by
from .declared_dependencies import DeclaredDependencies
from .ros1_headers import Ros1Headers
from .ros1_sources import Ros1Sources
from .undeclared_find_package import FindPackageDependencies

if TYPE_CHECKING:
    from .brought_by_cmake import BroughtByCMake
    from .header_providers import HeaderProviders
    from .included_packages import IncludedPackage, IncludedPackages
    from .including_files import IncludingFiles
    from .libraries_by_hand import LibrariesByHand


@dataclass(frozen=True)
class IncludeDependencies:
    """The packages whose headers C++ files include, and what package.xml declares."""

    declared: DeclaredDependencies
    files: PackageFiles
    cmake: CMake
    sources: tuple[CppFile, ...]
    interfaces: tuple[InterfaceFile, ...] = ()
    table: InstallTable = InstallTable()

    @cached_property
    def find_packages(self) -> FindPackageDependencies:
        return FindPackageDependencies(self.declared, self.cmake, self.interfaces)

    @cached_property
    def ros1(self) -> Ros1Sources:
        headers = Ros1Headers(self.declared.facts, self.files, self.declared.workspace)
        return Ros1Sources(headers, self.cmake, self.sources)

    @cached_property
    def providers(self) -> HeaderProviders:
        from .header_providers import HeaderProviders

        return HeaderProviders(self.declared, self.files, self.cmake, self.find_packages)

    @cached_property
    def included(self) -> IncludedPackages:
        from .included_packages import IncludedPackages

        return IncludedPackages(self.providers, self.ros1.headers, self.cmake, self.sources)

    @cached_property
    def including(self) -> IncludingFiles:
        from .including_files import IncludingFiles

        return IncludingFiles(self.declared, self.files, self.cmake, self.sources, self.table)

    @cached_property
    def required(self) -> BroughtByCMake:
        from .brought_by_cmake import BroughtByCMake  # most packages declare what they include

        return BroughtByCMake(self.cmake, self.find_packages, self.declared.workspace)

    @cached_property
    def by_hand(self) -> LibrariesByHand:
        from .libraries_by_hand import LibrariesByHand  # most packages declare what they include

        return LibrariesByHand(self.files, self.cmake, self.declared.workspace.index)

    def brought(self) -> Iterator[tuple[IncludedPackage, Bringer]]:
        """Yield what is included and not declared, and what brings it, or may: a dependency, or what CMake requires."""
        for each in self.undeclared():
            if bringer := self.bringer(each):
                yield each, bringer

    def bringer(self, each: IncludedPackage) -> Bringer | None:
        return self.declared.bringer(each.names, runs=False) or self.required.bringer(
            each.names, in_tests=each.role == "test"
        )

    def packages(self) -> tuple[IncludedPackage, ...]:
        """Return the packages and libraries whose headers are included, those of tests after those of what is built."""
        return self._packages

    @cached_property
    def _packages(self) -> tuple[IncludedPackage, ...]:
        return tuple(self.included.all()) if self.declared.is_checked else ()

    def undeclared(self) -> tuple[IncludedPackage, ...]:
        """Return what is included and not declared, without what CMake looks for and DEP104 reports."""
        return self._undeclared

    @cached_property
    def _undeclared(self) -> tuple[IncludedPackage, ...]:
        return tuple(self.without_brought_types(self.lacking()))

    def without_brought_types(self, found: Iterable[IncludedPackage]) -> Iterator[IncludedPackage]:
        """Yield some packages, without those of types alone that certainly come with another one of them."""
        every = list(found)
        for each in every:
            others = (one for one in every if not one.uses[0].is_type and one.role in ("run", each.role))
            first = {one.names[0] for one in others}
            is_brought = each.uses[0].is_type and each.names[0] in brought_by(sorted(first), self.declared.workspace)
            if not is_brought:
                yield each

    def lacking(self) -> Iterator[IncludedPackage]:
        """Yield the packages whose headers or types are used and that are not declared."""
        from .types_in_sources import packages_of_types

        there = implied_by(self.declared.names, IN_SOURCES)
        reported = {missing.found.name for missing in self.find_packages.missing()}
        named = {name for missing in self.find_packages.missing() for name in missing.names}
        for each in self.packages():
            is_reported = each.cmake in reported or not named.isdisjoint(each.names)
            is_reported = is_reported or bool(named and self.find_packages.provided.matching(each.cmake, named))
            is_settled = is_reported or bool(there.intersection(each.names)) or self.are_found_quietly(each)
            is_settled = is_settled or self.including.are_for_ros1(each)
            if not is_settled and not self.is_declared(each):
                reported.update(each.names)
                yield each
        types = packages_of_types(self.cmake, self.sources, self.declared.workspace) if self.declared.is_checked else ()
        for each in types:
            is_known = bool((reported | there).intersection(each.names))
            if not is_known and not self.is_declared(each) and not self.are_found_quietly(each):
                yield each

    def are_found_quietly(self, each: IncludedPackage) -> bool:
        """Return whether CMake looks for it without REQUIRED, and compiles what includes it under a condition alone."""
        names = {one.name for one in self.cmake.packages if not one.is_required}
        is_sought = not {each.cmake, *each.names}.isdisjoint(names)
        is_sought = is_sought or bool(names and self.find_packages.provided.matching(each.cmake, names))
        return is_sought and self.including.are_optional(each)

    def is_declared(self, each: IncludedPackage) -> bool:
        matching = self.find_packages.provided.matching
        return self.declared.has(each.names) or bool(matching(each.cmake, self.declared.names))

"""Packages that launch files use and package.xml does not declare (DEP103)."""

from __future__ import annotations

from functools import cached_property
from typing import TYPE_CHECKING, Annotated

from ...files import PackageFiles
from ...light_dataclasses import dataclass
from ...package.cmake.cmake_project import CMake
from ...package.install_table import InstallTable
from ...package.launch.launch_file import LaunchFile
from ...package.python.python_imports import PackageImports
from ...ros.implied_dependencies import IN_LAUNCH_FILES, IN_TESTS, LAUNCH, implied_by
from ...unreadable import READABLE
from ..launch.package_reference import PackageReference
from ..left_files import LeftFiles
from .declared_dependencies import DeclaredDependencies
from .launch_file_needs import LaunchFileNeeds
from .there_to_launch import there_to_launch
from .undeclared_imports import ImportDependencies

if TYPE_CHECKING:
    from .idle_launch_uses import IdleLaunchUses
    from .left_out_packages import LeftOutPackages
    from .unknown_launch_packages import UnknownLaunchPackages


@dataclass(frozen=True)
class LaunchDependencies:
    """The launch files of a package, and what it declares."""

    declared: DeclaredDependencies
    files: PackageFiles
    launch_files: Annotated[tuple[LaunchFile, ...], READABLE]
    cmake: CMake | None
    table: InstallTable | None
    python: PackageImports
    left: LeftFiles

    @cached_property
    def needs(self) -> LaunchFileNeeds:
        return LaunchFileNeeds(self.declared, self.files, self.launch_files, self.cmake, self.table)

    @cached_property
    def idle(self) -> IdleLaunchUses:
        from .idle_launch_uses import IdleLaunchUses  # most packages declare what they launch

        return IdleLaunchUses(self.launch_files, self.python, self.left)

    @cached_property
    def unknown(self) -> UnknownLaunchPackages:
        from .unknown_launch_packages import UnknownLaunchPackages

        return UnknownLaunchPackages(self.declared, self.files, self.launch_files, self.cmake)

    @cached_property
    def left_out(self) -> LeftOutPackages:
        from .left_out_packages import LeftOutPackages

        return LeftOutPackages(self.declared, self.files)

    def is_written(self, use: PackageReference) -> bool:
        """Return whether the place of a use holds the name itself, so that it can be replaced."""
        return self.files.source(use.path).slice(use.span) == use.name

    def missing(self, *, tests: bool) -> dict[str, list[PackageReference]]:
        """Return each package that is needed and not declared, with the places that need it."""
        if not self.declared.is_checked:
            return {}
        there = implied_by(self.declared.names, IN_TESTS if tests else IN_LAUNCH_FILES)
        there |= there_to_launch(self.declared) - (frozenset() if tests else LAUNCH)
        if tests:
            there |= self.missing(tests=False).keys()  # an exec_depend covers the tests
        found: dict[str, list[PackageReference]] = {}
        for use in self.needs.uses(tests=tests):
            is_reported = use.fails == "controller" and use.name in self.configured
            if self.declared.has_to_run(use.name) or use.name in there or is_reported:
                continue
            if use.name not in LAUNCH or not self.is_brought(use.name, tests=tests):
                found.setdefault(use.name, []).append(use)
        return found

    @cached_property
    def configured(self) -> frozenset[str]:
        """The packages of plugins that parameters and robots name, which DEP106 reports."""
        return frozenset(use.name.partition("/")[0] for use in self.declared.facts.plugin_uses)

    def is_brought(self, name: str, *, tests: bool) -> bool:
        """Return whether a declared dependency certainly brings a package."""
        bringer = self.declared.bringer([name], runs=not tests)
        return bringer is not None and bringer.is_certain

    def asked_for(self, *, tests: bool) -> dict[str, list[PackageReference]]:
        """Return what is missing, without what modules import undeclared, which DEP101 reports."""
        imported = ImportDependencies(self.declared, self.python, self.files).undeclared("run").keys() - LAUNCH
        return {name: uses for name, uses in self.missing(tests=tests).items() if tests or name not in imported}

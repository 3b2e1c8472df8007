"""The packages that the launch files of a package need: those of tests, and the others."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from functools import cached_property

from ...files import PackageFiles
from ...light_dataclasses import dataclass, replace
from ...package.cmake.cmake_project import CMake
from ...package.file_role import Role, role_of
from ...package.install_table import InstallTable
from ...package.launch.default_conditions import off_by_default
from ...package.launch.launch_file import LaunchFile
from ...package.launch.never_launched import never_shown
from ...package.launch.off_values import with_values
from ...ros.implied_dependencies import LAUNCH
from ..launch.package_reference import PackageReference
from ..launch.package_references import package_references
from .declared_dependencies import DeclaredDependencies
from .launch_file_imports import import_uses
from .named_sources import named_sources


@dataclass(frozen=True)
class LaunchFileNeeds:
    """The places of launch files that need a package, declared or not."""

    declared: DeclaredDependencies
    files: PackageFiles
    launch_files: tuple[LaunchFile, ...]
    cmake: CMake | None
    table: InstallTable | None

    def uses(self, *, tests: bool) -> tuple[PackageReference, ...]:
        """Return what the launch files of tests need, or what the others do."""
        return self._uses_in_tests if tests else self._uses

    @cached_property
    def _uses_in_tests(self) -> tuple[PackageReference, ...]:
        return tuple(
            use for file in self.launch_files if self.role(file.path) == "test" for use in with_conditions(file)
        )

    @cached_property
    def _uses(self) -> tuple[PackageReference, ...]:
        return tuple(
            use
            for file in self.launch_files
            if self.role(file.path) == "launch"
            for use in (
                *with_conditions(file),
                *import_uses(file, self.launch_files, self.declared, self.files),
                *self.reader_uses(file),
            )
        )

    def role(self, path: str) -> Role:
        """Return the role of a launch file; `aside` if it is in no launch folder and not installed."""
        role = role_of(path)
        if path in self.test_files or role == "test":
            return "test"
        if "launch" in path.split("/")[:-1] or self.table is None or not self.table.knows("share"):
            return "launch"
        return "launch" if path in {row.source for row in self.table.rows} else "aside"

    @cached_property
    def test_files(self) -> frozenset[str]:
        """The launch files that CMake names for tests and for nothing else."""
        if self.cmake is None:
            return frozenset()
        paths = {file.path for file in self.launch_files}
        named = {testing: named_sources(self.cmake, paths, testing) for testing in (False, True)}
        return frozenset(named[True] - named[False])

    def import_uses(self, file: LaunchFile) -> Iterator[PackageReference]:
        return import_uses(file, self.launch_files, self.declared, self.files)

    def reader_uses(self, file: LaunchFile) -> Iterator[PackageReference]:
        """Yield the package that reads a file in XML or YAML, where package.xml declares parts of launch by name."""
        if file.root is not None and not file.is_ros1 and file.nodes and not self.declared.names.isdisjoint(LAUNCH):
            at = file.root.name_span
            yield PackageReference(f"launch_{file.frontend}", file.path, at, "is read by")

    def with_included(self, uses: Iterable[PackageReference]) -> Iterator[PackageReference]:
        """Yield uses; `only_with` is the argument that must turn it on, also where an included file has it off."""
        from ..launch.included_defaults import off_when_included  # most packages declare what they launch

        files = {file.path: file for file in self.launch_files}
        own, included = self.declared.facts.name, self.declared.workspace.included_arguments
        for use in uses:
            off = () if use.only_with else off_when_included(files[use.path], own, included)
            inside = (part.argument for part in off if part.turns_off(use.span, is_late=use.is_late))
            yield replace(use, only_with=use.only_with or next(inside, ""))


def with_conditions(file: LaunchFile) -> Iterator[PackageReference]:
    """Yield what a launch file needs; `only_with` is the argument that must turn it on, where one is off by default.

    Actions that are built and never added to the launch description are left out.
    """
    off = tuple(with_values(file.python, off_by_default(file)))
    idle = tuple(never_shown(file.python)) if file.python is not None else ()
    for use in package_references(file):
        if use.is_late and any(each.contains(use.span) for each in idle):
            continue
        inside = (part.argument for part in off if part.turns_off(use.span, is_late=use.is_late))
        yield replace(use, only_with=next(inside, ""))

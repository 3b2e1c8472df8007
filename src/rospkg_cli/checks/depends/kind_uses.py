"""The places that use a dependency, and the tag of package.xml that each of them requires."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Literal

from ...light_dataclasses import dataclass
from ...package.interfaces.interface_file import InterfaceFile
from ...ros.implied_dependencies import IN_LAUNCH_FILES, IN_SOURCES, implied_by
from ...ros.manifest import BUILDS, RUNS, is_buildtool
from ...source import Span
from ..cmake.unguarded_tests import TEST_PACKAGES
from ..interfaces.package_interfaces import InterfaceGeneration
from ..launch.absent_package import ends_with
from ..launch.example_files import is_example
from .declared_dependencies import DeclaredDependencies
from .interface_needs import interface_needs
from .linked_at_run_time import is_served_at_run_time, loaded_libraries
from .required_by_cmake import stops_with
from .undeclared_imports import ImportDependencies
from .undeclared_includes import IncludeDependencies
from .undeclared_launch_packages import LaunchDependencies

Need = Literal["import", "launch", "include", "find", "link", "interface"]

RELEASED = "where only a release is installed,"

RUNTIME_OF_INTERFACES = "rosidl_default_runtime"
"""The tutorials of ROS declare it as exec_depend, even where CMake looks for it."""


@dataclass(frozen=True, slots=True)
class KindUse:
    """A place that uses a dependency, and the tag that such a use requires."""

    names: tuple[str, ...]
    need: Need
    path: str
    span: Span
    what: str
    """The module, the header, the package that CMake finds, the target that is linked, or the type of an interface; ""
    in a launch file."""
    ends: str = ""
    """What happens without it, where the need alone does not say."""
    is_optional: bool = False
    """Whether only files use it that are compiled on demand."""
    is_passed_on: bool = False
    """Whether only headers use it that the package installs for others and does not compile itself."""

    @property
    def wanted(self) -> str:
        if self.need == "find":
            return "buildtool_depend" if is_buildtool(self.names[0]) else "depend"
        return "depend" if self.need == "include" else "exec_depend"


@dataclass(frozen=True)
class KindUses:
    declared: DeclaredDependencies
    imports: ImportDependencies
    launch: LaunchDependencies
    includes: IncludeDependencies | None
    interfaces: tuple[InterfaceFile, ...]
    generation: InterfaceGeneration

    def all(self) -> Iterator[KindUse]:
        """Yield the uses at run time, in the build, and of shared libraries, in this order."""
        yield from self.at_run_time()
        yield from self.in_build()
        yield from self.loaded()

    def at_run_time(self) -> Iterator[KindUse]:
        """Yield what is used at run time, without what comes with other dependencies for it."""
        there = implied_by([d.name for d in self.declared.manifest.dependencies if d.tag in RUNS], IN_LAUNCH_FILES)
        for place, names in self.imports.uses("run"):
            yield KindUse(names, "import", place.path, place.span, place.module)
        for use in sorted(self.launch.needs.uses(tests=False), key=lambda use: is_example(use.path)):
            if use.name not in there:
                yield KindUse((use.name,), "launch", use.path, use.span, "", ends_with(use, use.name, RELEASED))
        for each in interface_needs(self.interfaces, self.generation):
            yield KindUse((each.package,), "interface", each.path, each.span, each.type)

    def loaded(self) -> Iterator[KindUse]:
        """Yield what installed programs and libraries load, without what other dependencies for running bring."""
        if self.includes is None:
            return
        there = frozenset(d.name for d in self.declared.manifest.dependencies if d.tag in RUNS)
        brought = self.declared.brings.brought_with(RUNS)
        for each in loaded_libraries(self.includes):
            found = self.declared.brings.bringer_among(each.names, brought)
            is_brought = found is not None and found.is_certain
            if not is_brought and not is_served_at_run_time(each.names, there):
                yield KindUse(each.names, "link", each.path, each.span, each.target)

    def in_build(self) -> Iterator[KindUse]:
        """Yield what CMake requires, as CMake stops first, then what is included and no dependency brings."""
        if self.includes is None:
            return
        there = implied_by([d.name for d in self.declared.manifest.dependencies if d.tag in BUILDS], IN_SOURCES)
        for found in self.includes.cmake.packages:
            names = self.includes.find_packages.needed_providers(found)
            others = {*TEST_PACKAGES, RUNTIME_OF_INTERFACES}  # the first are CMK107's
            if names and not found.call.testing and found.name not in others:
                ends = f"on the build farm the build stops {stops_with(found, self.includes.cmake)}"
                yield KindUse(names, "find", found.word.path, found.word.span, found.name, ends)
        for each in self.includes.packages():
            if each.role == "run" and not there.intersection(each.names):
                first = each.uses[0]
                including = self.includes.including
                optional, passed_on = including.are_optional(each), including.are_passed_on(each)
                yield KindUse(each.names, "include", first.path, first.span, first.header, "", optional, passed_on)

"""A package that generates interfaces, as far as its manifest has to say so."""

from __future__ import annotations

from functools import cached_property

from ...languages.cmake.evaluated_command import EvaluatedCommand
from ...light_dataclasses import dataclass
from ...package.cmake.cmake_project import CMake
from ...package.dependency import Dependency
from ...package.manifest import Manifest
from ...ros.interfaces import GENERATORS, GROUP, RUNTIMES
from ...ros.manifest import BUILDS, RUNS
from ..depends.brought_dependencies import Bringer
from ..depends.declared_dependencies import DeclaredDependencies

GENERATE = "rosidl_generate_interfaces"
SKIP_INSTALL, SKIP_CHECK = "SKIP_INSTALL", "SKIP_GROUP_MEMBERSHIP_CHECK"
"""Options of the call (rosidl_cmake/cmake/rosidl_generate_interfaces.cmake)."""


@dataclass(frozen=True)
class InterfacePackage:
    manifest: Manifest
    cmake: CMake
    declared: DeclaredDependencies

    @cached_property
    def installed(self) -> tuple[EvaluatedCommand, ...]:
        """The calls that generate interfaces for others than the package itself; what may skip that is left out.

        In a folder with a package.xml of its own, rosidl reads that one.
        """
        there = self.cmake.package_files.has_file
        calls = [
            call for call in self.cmake.named(GENERATE) if not (call.folder and there(f"{call.folder}/package.xml"))
        ]
        return tuple(call for call in calls if SKIP_INSTALL not in call.texts)

    @property
    def installs(self) -> bool:
        """Whether interfaces are generated that are of use without the package's tests."""
        return any(not call.testing for call in self.installed)

    @property
    def checks_group(self) -> bool:
        """Whether rosidl looks for the group."""
        return any(SKIP_CHECK not in call.texts for call in self.installed)

    @property
    def generators_to_run(self) -> Dependency | None:
        """The generators where they are declared for running, which brings the runtime as well."""
        found = (each for each in self.manifest.dependencies if each.name == GENERATORS[0] and each.tag in RUNS)
        return next(found, None)

    @property
    def runtime_bringer(self) -> Bringer | None:
        """The declared dependency that the runtime comes with, or may come with, as messages that these use do."""
        return self.declared.bringer(RUNTIMES, runs=True)

    @property
    def generators_bringer(self) -> Bringer | None:
        """The dependency that is declared for building and certainly brings the generators, on the build farm too."""
        bringer = self.declared.brings.bringer_among(GENERATORS, self.declared.brings.brought_with(BUILDS))
        return bringer if bringer is not None and bringer.is_certain else None

    def declares(self, name: str) -> bool:
        """Return whether package.xml names a package, be it in a way that another rule reports."""
        return self.manifest.depends_on(name) or self.declared.misnamed.has(name)

    @property
    def is_member(self) -> bool:
        return any(element.text == GROUP for element in self.manifest.all("member_of_group"))

"""The entry points in the setup.cfg of a package that CMake builds (SET108)."""

from __future__ import annotations

from collections.abc import Iterator

from ...light_dataclasses import dataclass
from ...package.cmake.ament_python_install import refused_entries
from ...package.cmake.cmake_project import CMake
from ...package.setup.entry_point import EntryPoint
from ..depends.own_imports import OwnImports
from ..unstarted_programs import UnstartedPrograms


@dataclass(frozen=True)
class CMakeEntryPoints:
    imports: OwnImports
    cmake: CMake | None
    programs: UnstartedPrograms

    def is_run(self, name: str) -> bool:
        """Return whether a launch file, a page, a script or code of the repository runs a program."""
        return self.programs.is_run(name)

    def refused(self) -> Iterator[EntryPoint]:
        """Yield what setuptools refuses in a setup.cfg that CMake certainly gives it."""
        calls = self.cmake.named("ament_python_install_package") if self.cmake else []
        for call in calls:
            yield from () if call.maybe else refused_entries(call, self.imports.files)

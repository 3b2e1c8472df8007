"""Rule input: places that neither a build nor a run uses by default: they are switched off, or not chosen."""

from __future__ import annotations

from functools import cached_property
from typing import Annotated

from ..languages.cmake.evaluated_command import path_in_package
from ..languages.cmake.targets import Target
from ..languages.cpp.file import CppFile
from ..light_dataclasses import dataclass
from ..package.cmake.cmake_project import CMake
from ..package.launch.default_conditions import off_by_default
from ..package.launch.launch_file import LaunchFile
from ..source import Span
from ..unreadable import READABLE
from .cmake.switched_off import SwitchedOff
from .cpp.switches_in_cpp import is_never
from .depends.compiled_sources import harm_in
from .reached_definitions import ReachedDefinitions
from .unset_switches import UnsetSwitches
from .unstarted_programs import UnstartedPrograms


@dataclass(frozen=True)
class IdlePaths:
    switches: UnsetSwitches
    definitions: ReachedDefinitions
    programs: UnstartedPrograms | None = None
    cmake: CMake | None = None
    sources: Annotated[tuple[CppFile, ...], READABLE] = ()
    launches: Annotated[tuple[LaunchFile, ...], READABLE] = ()

    def has(self, path: str, span: Span) -> bool:
        """Return whether a switch keeps a place from running, or a launch file does not choose it by default."""
        if path.endswith("CMakeLists.txt"):
            return self.is_out_of_build(path, span)
        file = self.switches.run.modules.at(path) if path.endswith(".py") else None
        is_off = file is not None and self.definitions.is_turned_off(file, span)
        source = next((each for each in self.sources if each.path == path), None)
        if is_off or self.switches.why_off(path, span) or (source is not None and is_never(source, span)):
            return True
        own = (each for each in self.launches if each.path == path)
        return any(part.span.holds(span) for each in own for part in off_by_default(each))

    def is_out_of_build(self, path: str, span: Span) -> bool:
        """Return whether a place of CMake is only in commands that are off by default or never run."""
        every = (*self.cmake.calls, *self.cmake.unreachable) if self.cmake is not None else ()
        around = [call for call in every if call.path == path and call.command.span.holds(span)]
        return bool(around) and all(self.off.has(call) or self.off.is_never_run(call) for call in around)

    @cached_property
    def off(self) -> SwitchedOff:
        assert self.cmake is not None
        return SwitchedOff(self.cmake)

    def is_of_idle_program(self, path: str) -> bool:
        """Return whether a source is compiled only on demand, or only into programs that nothing starts while others
        are started.
        """
        if self.cmake is None or all(each.path != path for each in self.sources):
            return False
        own = [each for each in self.cmake.targets if self.compiles(each, path)]
        if own and harm_in(self.cmake, self.sources, path) == "info":
            return True
        programs = self.programs
        is_known = programs is not None and bool(own) and all(each.is_executable for each in own)
        return is_known and programs is not None and all(programs.is_beside_started(each.name) for each in own)

    def compiles(self, target: Target, path: str) -> bool:
        return any(path_in_package(word.text, target.call.folder) == path for word in target.sources)

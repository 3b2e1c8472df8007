"""The file name of a target on Linux, and the folder that `install(TARGETS …)` installs it to."""

from __future__ import annotations

from functools import cached_property

from ...languages.cmake.targets import Target
from ...languages.cmake.values import UNKNOWN
from ...light_dataclasses import dataclass
from .cmake_project import CMake
from .install_rule import InstallRule
from .target_properties import SETTERS, properties

PYTHON_MODULES = frozenset({"pybind11_add_module", "nanobind_add_module", "python3_add_library", "python_add_library"})
"""Commands whose libraries Python imports: no `lib` prefix, and a suffix that depends on the Python version."""


@dataclass(frozen=True)
class Artifacts:
    cmake: CMake

    def destination(self, rule: InstallRule, target: Target) -> str | None:
        """Return the folder that a target goes to: that of its kind of artifact, the general one, or CMake's own."""
        destinations = rule.destinations or {}
        kind = target.artifact
        if kind in destinations or "" in destinations:
            return destinations.get(kind, destinations.get(""))
        return "bin" if target.is_executable else "lib"

    def file_name(self, target: Target) -> str:
        """Return the name of a target's file; a library of no given kind is taken for a shared one.

        It is one where BUILD_SHARED_LIBS is on, which ament_cmake_ros sees to, and with it rosidl.
        """
        name = self.cmake.output_names.get(target.name, target.name)
        python = target.call.name in PYTHON_MODULES
        start = "" if python or target.is_executable else "lib"
        end = "" if target.is_executable else ".a" if "STATIC" in target.options else ".so"
        return self.prefixes.get(target.name, start) + name + self.suffixes.get(target.name, end)

    @cached_property
    def prefixes(self) -> dict[str, str]:
        return self.known("PREFIX")

    @cached_property
    def suffixes(self) -> dict[str, str]:
        return self.known("SUFFIX")

    def known(self, name: str) -> dict[str, str]:
        calls = self.cmake.named(*SETTERS)
        return {target: value for target, value in properties(calls, name) if UNKNOWN not in value}

"""Linters that the generators of interfaces look for and that package.xml does not declare (DEP122)."""

from __future__ import annotations

from collections.abc import Iterator

from ...light_dataclasses import dataclass
from ...package.cmake.cmake_project import CMake
from ...source import Span
from .declared_dependencies import DeclaredDependencies

FLAG = "ADD_LINTER_TESTS"
NEEDED = "ament_cmake_cppcheck"
"""What rosidl_generator_c requires first, of three or more."""
ALL = "ament_lint_common"
GENERATORS = ("rosidl_default_generators", "rosidl_generator_py")


@dataclass(frozen=True)
class InterfaceLinters:
    declared: DeclaredDependencies
    cmake: CMake

    def unmet(self) -> Iterator[tuple[str, Span]]:
        """Yield the places that turn on linters which no dependency brings and CMake does not look for.

        The generators bring them since Jazzy; what else may bring them counts as well.
        """
        if not self.declared.is_checked or self.declared.has([NEEDED, ALL]) or self.is_found:
            return
        bringer = self.declared.bringer([NEEDED, ALL], runs=False)
        if bringer is None or (bringer.name in GENERATORS and not bringer.is_certain):
            for call in self.cmake.named("rosidl_generate_interfaces"):
                flag = next((word for word in call.words[1:] if word.text == FLAG and not word.maybe), None)
                if flag is not None and not call.maybe:
                    yield flag.path, flag.span

    @property
    def is_found(self) -> bool:
        """Whether CMake looks for the linters itself, which DEP104 reports, or an unread CMake file may do so."""
        found = {each.name for each in self.cmake.packages}
        return bool(found & {NEEDED, ALL}) or self.cmake.reads_unknown_files

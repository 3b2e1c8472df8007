"""Commands for tests whose package CMake does not find and package.xml does not declare (DEP104)."""

from __future__ import annotations

from collections.abc import Iterator

from ...languages.cmake.evaluated_command import EvaluatedCommand
from ...light_dataclasses import dataclass
from ...package.cmake.cmake_project import CMake
from ...ros.implied_dependencies import IN_CMAKE, implied_by
from .declared_dependencies import DeclaredDependencies
from .needed_find_packages import OF_COMMANDS
from .transitive_dependencies import exported_by


@dataclass(frozen=True, slots=True)
class UndeclaredTestCommand:
    call: EvaluatedCommand
    package: str
    may_be_brought: bool
    """Whether another package may bring it that is found or declared."""


@dataclass(frozen=True)
class CommandsForTests:
    declared: DeclaredDependencies
    cmake: CMake

    def undeclared(self) -> Iterator[UndeclaredTestCommand]:
        """Yield the first call for each package that neither CMake nor package.xml names, and that no other brings.

        A package that is declared is found by `ament_lint_auto_find_test_dependencies()` and the like.
        """
        if not self.declared.is_checked or not self.cmake.is_complete or self.cmake.reads_unknown_files:
            return
        found = {each.name for each in self.cmake.packages}
        brought, known = exported_by(found, self.declared.workspace)
        seen = found | brought | self.cmake.functions | implied_by(found | self.declared.names, IN_CMAKE)
        for call in self.cmake.calls:
            package = OF_COMMANDS.get(call.name, "")
            if not package or call.maybe or {package, call.name} & seen:
                continue
            seen.add(package)
            bringer = self.declared.bringer([package], runs=False)
            if not self.declared.has([package]) and not (bringer and bringer.is_certain):
                yield UndeclaredTestCommand(call, package, not known or bringer is not None)

"""A target that is linked against what another package has."""

from __future__ import annotations

from collections.abc import Iterator

from ..edits.cmake_commands import add_after, add_argument, match_case, remove
from ..languages.cmake.syntax import CommandInvocation
from ..light_dataclasses import dataclass
from ..package.cmake.cmake_facts import SEARCHES
from ..package.cmake.cmake_project import CMake
from ..package.package import Package
from ..ros.names import BUILT_IN
from .cmake_block import argument_removals
from .cmake_find import cmake_of
from .part import Operations

LINKERS = ("target_link_libraries", "ament_target_dependencies")


@dataclass(frozen=True)
class Linked:
    """`${NAME_TARGETS}` among what a target is linked with, the name alone in ament_target_dependencies."""

    target: str
    name: str

    def add(self, package: Package) -> Operations:
        """Return the edit, nothing where the target is linked already, or in a way that can't be seen here."""
        cmake = cmake_of(package)
        if cmake.named(*SEARCHES) or not BUILT_IN.is_package(self.name) or self.is_there(cmake):
            return ()
        calls = self.calls(cmake)
        if calls:
            return (add_argument(cmake.root, calls[-1], self.written(calls[-1].name)),)
        target = cmake.target(self.target)
        if target is None or not cmake.root.is_top(target.call.command):
            return ()
        return (add_after(cmake.root, target.call.command, self.line()),)

    def written(self, command: str) -> str:
        return self.name if command == "ament_target_dependencies" else f"${{{self.name}_TARGETS}}"

    def line(self) -> str:
        return f"target_link_libraries({self.target} PRIVATE {self.written('')})"

    def is_there(self, cmake: CMake) -> bool:
        """Return whether a call about the target names the package or a target of it."""
        texts = [
            text
            for call in cmake.named(*LINKERS)
            if call.texts and call.texts[0] == self.target
            for text in call.texts[1:]
        ]
        raw = [argument.text for command in self.calls(cmake) for argument in command.arguments]
        return any(
            text == self.name or text.startswith((f"{self.name}::", f"${{{self.name}_")) for text in [*texts, *raw]
        )

    def calls(self, cmake: CMake) -> list[CommandInvocation]:
        """Return the commands outside of blocks that link the target, those of CMake's own kind last."""
        found = [
            each
            for each in cmake.root.top
            if each.name in LINKERS and len(each.arguments) > 1 and self.is_about(cmake, each)
        ]
        return sorted(found, key=lambda each: LINKERS[::-1].index(each.name))

    def is_about(self, cmake: CMake, command: CommandInvocation) -> bool:
        first = command.arguments[0].text
        return self.target in (first, first.replace("${PROJECT_NAME}", cmake.project_name))

    def remove(self, package: Package) -> Iterator[Operations]:
        """Yield the removal of the name, of the whole command where it links nothing else."""
        cmake = cmake_of(package)
        line = match_case(cmake.root, self.line())
        for command in self.calls(cmake):
            if cmake.root.source.slice(command.span) == line:
                yield (remove(cmake.root, command),)
            for argument in command.arguments[1:]:
                if argument.text == self.written(command.name):
                    yield from argument_removals(cmake.root, argument.span)

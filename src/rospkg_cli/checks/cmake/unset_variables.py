"""Variables in CMakeLists.txt that nothing sets, so that they are empty, and whose name is near one that is set."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cached_property
from itertools import takewhile

from ...languages.cmake.command_blocks import Block
from ...languages.cmake.evaluated_command import EvaluatedCommand
from ...languages.cmake.syntax import CommandArgument
from ...languages.cmake.values import Word
from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...package.cmake.cmake_package import CMakePackage
from ...package.cmake.cmake_project import CMake
from ...package.workspace import Workspace
from ...source import Span
from ...suggest import distance
from .intended_variables import IntendedVariables
from .known_packages import are_all_known
from .name_slips import are_swapped
from .set_by_cmake import SET_BY_CMAKE
from .unset_variable import UnsetVariable

REFERENCE = regex(r"(?<!\\)\$\{([A-Za-z_]\w*)\}")
OF_TARGETS = ("ament_target_dependencies", "target_link_libraries", "target_include_directories", "add_executable")
"""Commands whose first argument is a target."""


@dataclass(frozen=True)
class UnsetVariables:
    package: CMakePackage
    workspace: Workspace

    @property
    def cmake(self) -> CMake:
        return self.package.cmake

    def all(self) -> Iterator[UnsetVariable]:
        """Yield each place once; only slips of PROJECT_NAME where a file that can't be read may set any variable."""
        if self.cmake.reads_unknown_files:
            yield from self.of_the_project()
            return
        seen: set[tuple[str, int]] = set()
        for call in self.cmake.calls:
            place = (call.path, call.command.span.start)
            if place not in seen and call.name != "message":
                seen.add(place)
                for argument in call.command.arguments:
                    yield from self.within(call, argument)
        yield from self.of_loops()
        yield from self.of_targets()

    def is_certain(self, each: UnsetVariable) -> bool:
        """Return whether a variable is certainly empty, and the intended one certain.

        It is one letter off the intended one, and no unknown package may set it. No package sets a variable whose name
        is near one of CMake.
        """
        if self.cmake.reads_unknown_files or (each.near and not is_one_letter_off(each.name, each.near)):
            return False
        is_own = not each.near or each.near in self.intended.assigned
        return each.near in SET_BY_CMAKE or (is_own and (self.are_known or are_swapped(each.name, each.near)))

    @cached_property
    def are_known(self) -> bool:
        return are_all_known(self.cmake, self.workspace)

    def of_the_project(self) -> Iterator[UnsetVariable]:
        """Yield slips of PROJECT_NAME in `install()`, by names that stand nowhere outside of `${…}`."""
        for call in (each for each in self.cmake.calls if each.name == "install"):
            for argument in call.command.arguments:
                yield from self.within(call, argument)

    def of_loops(self) -> Iterator[UnsetVariable]:
        """Yield variables in `foreach()` at the top level of a file: CMake skips a loop over nothing silently."""
        root = self.cmake.root
        for command in (each.command for each in root.body if isinstance(each, Block)):
            for argument in command.arguments[1:] if command.name == "foreach" else ():
                yield from self.within(EvaluatedCommand(command, (), root.path, ""), argument)

    def within(self, call: EvaluatedCommand, argument: CommandArgument) -> Iterator[UnsetVariable]:
        """Yield the unset variables of one argument, where another variable is near."""
        if argument.kind == "bracket" or "${" not in argument.text:
            return
        for found in REFERENCE.finditer(argument.text):
            if near := self.intended.in_call(found[1], call):
                start = argument.inner.start
                span = Span(start + found.start(), start + found.end())
                after = argument.text.replace(found[0], "")
                yield UnsetVariable(found[1], near, call, span, argument.text, after)

    def of_targets(self) -> Iterator[UnsetVariable]:
        """Yield unset variables that stand for targets or for files of interfaces, though no other variable is near."""
        for rule in self.cmake.installs:
            for word in rule.items if rule.kind == "TARGETS" and not rule.call.maybe else ():
                name = self.intended.variables.empty_variable(word)
                if name is not None and not self.intended.nearest(name):
                    yield UnsetVariable(name, "", rule.call, word.span, f"${{{name}}}", "")
        for call, word in self.needed():
            name = self.intended.variables.empty_variable(word) if not call.maybe else None
            if name is not None and not self.intended.nearest(name):
                yield UnsetVariable(name, "", call, word.span, f"${{{name}}}", "")

    def needed(self) -> Iterator[tuple[EvaluatedCommand, Word]]:
        """Yield the arguments without which CMake stops: the target of a command, the files of interfaces."""
        for call in self.cmake.named(*OF_TARGETS):
            yield from ((call, word) for word in call.words[:1])
        for call in self.cmake.named("rosidl_generate_interfaces"):
            files = tuple(takewhile(lambda word: not word.text.isupper(), call.words[1:]))
            if all(self.intended.variables.empty_variable(word) for word in files):
                yield from ((call, word) for word in files)

    @cached_property
    def intended(self) -> IntendedVariables:
        return IntendedVariables(self.cmake, self.workspace)


def is_one_letter_off(name: str, near: str) -> bool:
    return distance(name, near, 1) <= 1 and name.lower() != near.lower()

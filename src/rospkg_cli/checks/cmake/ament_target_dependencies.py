"""Calls of ament_target_dependencies, and their replacement with `target_link_libraries`."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cached_property
from typing import Literal

from ...languages.cmake.evaluated_command import EvaluatedCommand
from ...languages.cmake.file import CMakeFile
from ...languages.cmake.syntax import CommandArgument, CommandInvocation
from ...languages.cmake.values import UNKNOWN, Word
from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...package.cmake.cmake_package import CMakePackage
from ...package.workspace import Workspace
from ...ros.distros import Targets
from ...ros.link_targets import LinkTargets, link_targets
from .distro_guards import guarded_commands

REMOVED = "ament_target_dependencies"
KEYWORDS = ("PUBLIC", "PRIVATE", "INTERFACE")
LINK_KEYWORDS = (*KEYWORDS, "LINK_PUBLIC", "LINK_PRIVATE", "LINK_INTERFACE_LIBRARIES")
LINK_PLAINLY = ("ament_add_gtest", "ament_add_gmock", "ament_add_gtest_executable", "ament_add_gmock_executable",
                "ament_add_google_benchmark", "ament_auto_add_gtest", "ament_auto_add_library",
                "ament_auto_add_executable", "ament_add_ros_isolated_gtest",
                "ament_add_ros_isolated_gmock")  # fmt: skip
"""Commands that link their target without a keyword: CMake then refuses keywords in other calls."""

LIBRARIES = regex(r"\$\{\w+_(LIBRARIES|LIBS|TARGETS)\}")

Signature = Literal["plain", "keyword"]


@dataclass(frozen=True)
class RemovedCommand:
    """One place where the command is written, with every run of it."""

    file: CMakeFile
    command: CommandInvocation
    calls: tuple[EvaluatedCommand, ...]


@dataclass(frozen=True)
class ReplacedArgument:
    """An argument, and what to write for it: None leaves it, nothing takes it out."""

    argument: CommandArgument
    texts: tuple[str, ...] | None = None


@dataclass(frozen=True)
class Replacement:
    parts: tuple[ReplacedArgument, ...]
    signature: Signature
    keyword: str
    """The keyword that the command has; "" where it has none."""
    includes: tuple[str, ...]
    guessed: tuple[str, ...]
    """Packages of which it is unknown whether they export targets."""


@dataclass(frozen=True)
class AmentTargetDependencies:
    package: CMakePackage
    workspace: Workspace
    targets: Targets

    def removed(self) -> Iterator[RemovedCommand]:
        """Yield every place where the command is written, also where nothing runs it, but not what asks for the
        distribution first."""
        cmake = self.package.cmake
        runs: dict[tuple[str, int], list[EvaluatedCommand]] = {}
        unreached = [call for call in cmake.unreachable if call.name == REMOVED]
        for call in cmake.named(REMOVED):
            runs.setdefault((call.path, call.command.span.start), []).append(call)
        for call in unreached:
            runs.setdefault((call.path, call.command.span.start), [call])
        for file in cmake.files:
            elsewhere = {id(command) for command in guarded_commands(file.body)}
            for command in file.syntax.commands:
                if command.name == REMOVED and id(command) not in elsewhere:
                    yield RemovedCommand(file, command, tuple(runs.get((file.path, command.span.start), ())))

    def replacement(self, removed: RemovedCommand) -> Replacement | None:
        """Return what to write instead; None where an argument can't be evaluated."""
        if not removed.calls or not removed.command.arguments:
            return None
        signatures = {self.signature(call) for call in removed.calls}
        arguments = self.arguments(removed)
        if len(signatures) > 1 or arguments is None:
            return None
        done: set[str] = set()
        parts, keyword = [ReplacedArgument(removed.command.arguments[0])], ""
        includes: list[str] = []
        guessed: list[str] = []
        for argument, names in arguments:
            if argument.text in KEYWORDS or is_kept(argument):
                keyword = argument.text if argument.text in KEYWORDS else keyword
                parts.append(ReplacedArgument(argument))
                continue
            found = [(name, self.link_targets(name)) for name in names if name != "SYSTEM"]
            texts: list[str] = []
            for name, link in found:
                texts += [target for target in link.targets if target not in done]
                includes += link.includes
                guessed += [] if link.certain else [name]
                done |= set(link.targets)
            parts.append(ReplacedArgument(argument, tuple(texts)))
        return Replacement(tuple(parts), signatures.pop(), keyword, tuple(dict.fromkeys(includes)), tuple(guessed))

    def arguments(self, removed: RemovedCommand) -> list[tuple[CommandArgument, tuple[str, ...]]] | None:
        """Return the arguments after the target, each with the names it expands to; None where that is unknown."""
        seen = [list(call.by_argument())[1:] for call in removed.calls]
        first = [(argument, tuple(word.text for word in words)) for argument, words in seen[0]]
        for each in seen:
            if any(not is_plain(word) for argument, words in each if not is_kept(argument) for word in words):
                return None
            if [(argument, tuple(word.text for word in words)) for argument, words in each] != first:
                return None
        return first

    def link_targets(self, name: str) -> LinkTargets:
        facts = self.workspace.named(name)
        if facts is None:
            return link_targets(name)
        if facts.cmake_targets or facts.build_type != "ament_cmake":
            return link_targets(name, facts.cmake_targets)
        if facts.interfaces:
            return LinkTargets((f"${{{name}_TARGETS}}",))
        return LinkTargets((f"${{{name}_LIBRARIES}}",), (f"${{{name}_INCLUDE_DIRS}}",))

    def signature(self, call: EvaluatedCommand) -> Signature:
        """Return how the call's target is linked elsewhere: CMake refuses to mix the two."""
        target = call.texts[0] if call.texts else UNKNOWN
        return self.signatures.get(target, "keyword")

    @cached_property
    def signatures(self) -> dict[str, Signature]:
        cmake = self.package.cmake
        found: dict[str, Signature] = {}
        for call in cmake.named("target_link_libraries"):
            if len(call.texts) > 1:
                found.setdefault(call.texts[0], "keyword" if call.texts[1] in LINK_KEYWORDS else "plain")
        plain = [target.name for target in cmake.targets if target.call.name in LINK_PLAINLY]
        return {**found, **dict.fromkeys(plain, "plain")}


def is_kept(argument: CommandArgument) -> bool:
    """Return whether an argument can be linked as it is: `${Eigen_LIBRARIES}`."""
    return LIBRARIES.fullmatch(argument.text) is not None


def is_plain(word: Word) -> bool:
    return word.is_known and not word.maybe and word.text != UNKNOWN

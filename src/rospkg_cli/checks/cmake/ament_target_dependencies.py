"""Calls of ament_target_dependencies, and their replacement with `target_link_libraries`."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cached_property

from ...languages.cmake.evaluated_command import EvaluatedCommand
from ...languages.cmake.syntax import CommandArgument
from ...languages.cmake.values import UNKNOWN, Word
from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...package.cmake.cmake_package import CMakePackage
from ...package.workspace import Workspace
from ...ros.distros import Targets
from ...ros.link_targets import LinkTargets, link_targets
from .distro_guards import guarded_commands
from .link_keywords import KEYWORDS, Signature, signatures
from .removed_command import RemovedCommand, ReplacedArgument, Replacement

REMOVED = "ament_target_dependencies"
LIBRARIES = regex(r"\$\{\w+_(LIBRARIES|LIBS|TARGETS)\}")


@dataclass(frozen=True)
class AmentTargetDependencies:
    package: CMakePackage
    workspace: Workspace
    targets: Targets

    def removed(self) -> Iterator[RemovedCommand]:
        """Yield every place where the command is written, also where it is never run; not below a check of the
        distribution."""
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
        """Return the targets to link for a package, or its variables where it has none."""
        facts = self.workspace.named(name)
        if facts is None:
            return link_targets(name)
        if facts.cmake_targets or facts.build_type != "ament_cmake":
            return link_targets(name, facts.cmake_targets)
        if facts.interfaces:
            return LinkTargets((f"${{{name}_TARGETS}}",))
        return LinkTargets((f"${{{name}_LIBRARIES}}",), (f"${{{name}_INCLUDE_DIRS}}",))

    def signature(self, call: EvaluatedCommand) -> Signature:
        """Return how the call's target is linked elsewhere."""
        target = call.texts[0] if call.texts else UNKNOWN
        return self.signatures.get(target, "keyword")

    @cached_property
    def signatures(self) -> dict[str, Signature]:
        return signatures(self.package.cmake)


def is_kept(argument: CommandArgument) -> bool:
    """Return whether an argument can be linked as it is: `${Eigen_LIBRARIES}`."""
    return LIBRARIES.fullmatch(argument.text) is not None


def is_plain(word: Word) -> bool:
    return word.is_known and not word.maybe and word.text != UNKNOWN

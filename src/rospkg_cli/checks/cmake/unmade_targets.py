"""Branches that ask for a target (`if(TARGET plugins)`) which is made in branches alone that are never taken."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cached_property

from ...languages.cmake.command_blocks import Block, Branch
from ...languages.cmake.evaluated_command import EvaluatedCommand
from ...languages.cmake.syntax import CommandInvocation
from ...languages.cmake.targets import MAKERS
from ...languages.cmake.values import UNKNOWN
from ...light_dataclasses import dataclass
from ...package.cmake.cmake_project import CMake
from ...package.cmake.foreign_commands import foreign_commands

FINDING = ("find_package", "fetchcontent_declare", "fetchcontent_makeavailable", "pkg_check_modules", "ament_vendor")
"""Commands that may bring targets of what they name."""
EITHER = frozenset({"OR", "(", ")"})


@dataclass(frozen=True)
class UnmadeTargets:
    cmake: CMake

    def silence(self, call: EvaluatedCommand) -> bool:
        """Return whether a call is certainly not run, as a target is not there that its branch asks for."""
        return not self.unmade.isdisjoint(self.asked.get(id(call.command), ()))

    @cached_property
    def unmade(self) -> frozenset[str]:
        """The targets that only commands make which are never run; nothing where other files may make any."""
        cmake = self.cmake
        if not cmake.is_complete or cmake.reads_unknown_files or next(foreign_commands(cmake), None) is not None:
            return frozenset()
        names = {each.texts[0] for each in cmake.unreachable if each.name in MAKERS and each.words}
        made = {each.name for each in cmake.targets}
        brought = " ".join(text for call in cmake.named(*FINDING) for text in call.texts).lower()
        is_open = any(UNKNOWN in name for name in made)
        return frozenset(each for each in names - made if each.lower() not in brought and not is_open)

    @cached_property
    def asked(self) -> dict[int, frozenset[str]]:
        """Command → the targets for which the branches ask that it is in."""
        found: dict[int, frozenset[str]] = {}
        waiting: list[tuple[CommandInvocation | Block, frozenset[str]]]
        waiting = [(each, frozenset()) for file in self.cmake.files for each in file.body]
        while waiting:
            each, names = waiting.pop()
            if isinstance(each, CommandInvocation):
                found[id(each)] = names
                continue
            for branch in each.branches:
                inner = names.union(asked_by(branch))
                waiting += [(below, inner) for below in branch.body]
        return found


def asked_by(branch: Branch) -> Iterator[str]:
    """Yield the targets without which a branch is not taken."""
    texts = [each.text for each in branch.command.arguments]
    if branch.command.name in ("if", "elseif") and EITHER.isdisjoint(texts):
        for before, test, name in zip(["", *texts], texts, texts[1:], strict=False):
            if test == "TARGET" and before != "NOT":
                yield name

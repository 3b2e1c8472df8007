"""Branches that ask for a target (`if(TARGET plugins)`) that is made only in branches that are never taken."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import cached_property

from ...languages.cmake.evaluated_command import EvaluatedCommand
from ...languages.cmake.targets import MAKERS
from ...languages.cmake.values import UNKNOWN
from ...light_dataclasses import dataclass
from ...package.cmake.cmake_project import CMake
from ...package.cmake.foreign_commands import foreign_commands
from .branch_names import names_around

FINDING = ("find_package", "fetchcontent_declare", "fetchcontent_makeavailable", "pkg_check_modules", "ament_vendor")
"""Commands that may bring targets of what they name."""


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
    def asked(self) -> dict[int, tuple[str, ...]]:
        """Command → the targets for which the branches ask that it is in."""
        return names_around(self.cmake, targets_in)


def targets_in(texts: Sequence[str]) -> Iterator[str]:
    """Yield the targets without which a condition does not hold."""
    for before, test, name in zip(["", *texts], texts, texts[1:], strict=False):
        if test == "TARGET" and before != "NOT":
            yield name

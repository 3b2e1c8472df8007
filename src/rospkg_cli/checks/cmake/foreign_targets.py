"""Targets of packages (`rclcpp::rclcpp`), where commands of ament are given packages."""

from __future__ import annotations

from collections.abc import Iterator

from ...languages.cmake.evaluated_command import EvaluatedCommand
from ...languages.cmake.values import Word
from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...package.cmake.cmake_package import CMakePackage
from ..enumeration import in_ticks

NAMESPACED = regex(r"([A-Za-z][\w.+-]*)::[\w.+:-]+")
TAKING = {"ament_target_dependencies": 1, "ament_export_dependencies": 0}
"""Commands that are given packages, and their first argument that is one."""


@dataclass(frozen=True)
class ForeignTargets:
    """The targets that one call is given; they may come from a variable that links them, too."""

    call: EvaluatedCommand
    words: tuple[Word, ...]

    @property
    def names(self) -> str:
        return in_ticks(dict.fromkeys(word.text for word in self.words))

    @property
    def packages(self) -> tuple[str, ...]:
        """The packages that have them, each once."""
        return tuple(dict.fromkeys(word.text.partition("::")[0] for word in self.words))

    @property
    def only_own(self) -> Word | None:
        """The one target, where the call itself names it."""
        word, *others = self.words
        span = self.call.command.span
        is_inside = word.path == self.call.path and span.holds(word.span)
        return word if is_inside and not others else None


def foreign_targets(package: CMakePackage) -> Iterator[ForeignTargets]:
    """Yield each call that certainly is given targets: no package can have such a name."""
    seen: set[tuple[str, int]] = set()
    for call in package.cmake.named(*TAKING):
        given = call.words[TAKING[call.name] :]
        words = tuple(word for word in given if is_target(word))
        key = (call.path, call.command.span.start)
        if words and not call.maybe and key not in seen:
            seen.add(key)
            yield ForeignTargets(call, words)


def is_target(word: Word) -> bool:
    return word.is_known and not word.maybe and NAMESPACED.fullmatch(word.text) is not None

"""Targets that exported ones are linked with and that are not exported, at which `install(EXPORT)` stops CMake."""

from __future__ import annotations

from collections.abc import Iterator

from ...languages.cmake.targets import Target
from ...languages.cmake.values import Word
from ...light_dataclasses import dataclass
from .cmake_project import CMake
from .target_links import TargetLinks
from .uninstalled_target import TargetUse, UninstalledTarget

MADE_BY = ("add_executable", "add_library", "ament_auto_add_executable", "ament_auto_add_library", "cuda_add_library",
           "cuda_add_executable", "generate_parameter_library")  # fmt: skip
"""Commands that make a target with a file to install."""


@dataclass(frozen=True)
class UnexportedLinks:
    cmake: CMake
    links: TargetLinks

    def all(self) -> Iterator[UninstalledTarget]:
        """Yield each target once, with the first exported target that is linked with it."""
        exports = {text for call in self.cmake.exports for text in call.texts}
        rules = [rule for rule in self.cmake.installs if rule.export is not None]
        exported = {word.text for rule in rules for word in rule.items}
        seen: set[str] = set()
        for rule in rules:
            if rule.export is None or rule.export.text not in exports or rule.call.maybe:
                continue
            for word in rule.items:
                for name in self.interface_of(word):
                    target = self.cmake.target(name)
                    if target is not None and name not in exported and name not in seen and is_refused(target):
                        seen.add(name)
                        yield UninstalledTarget(target, TargetUse("exported target", word.text), stops=True)

    def interface_of(self, word: Word) -> Iterator[str]:
        """Yield the package's targets that are linked along with a target."""
        static = (target := self.cmake.target(word.text)) is not None and "STATIC" in target.options
        for link in self.links.of(word.text):
            if (link.is_public or static) and not link.package and not link.call.maybe and not link.word.maybe:
                yield link.word.text


def is_refused(target: Target) -> bool:
    """Return whether CMake stops where a target is linked and not exported."""
    return target.call.name in MADE_BY and not target.call.maybe and not target.options & {"IMPORTED", "ALIAS"}

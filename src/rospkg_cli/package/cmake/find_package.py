"""Calls of find_package."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from ...languages.cmake.evaluated_command import EvaluatedCommand
from ...languages.cmake.values import Word
from ...light_dataclasses import dataclass

FIND_KEYWORDS = frozenset({
    "EXACT", "QUIET", "MODULE", "REQUIRED", "COMPONENTS", "OPTIONAL_COMPONENTS", "CONFIG", "NO_MODULE", "GLOBAL",
    "NO_POLICY_SCOPE", "NAMES", "HINTS", "PATHS", "PATH_SUFFIXES", "CONFIGS", "NO_DEFAULT_PATH", "NO_CMAKE_PATH",
    "NO_PACKAGE_ROOT_PATH", "NO_CMAKE_FIND_ROOT_PATH", "NO_CMAKE_ENVIRONMENT_PATH", "NO_SYSTEM_ENVIRONMENT_PATH",
    "NO_CMAKE_PACKAGE_REGISTRY", "NO_CMAKE_SYSTEM_PATH", "CMAKE_FIND_ROOT_PATH_BOTH", "ONLY_CMAKE_FIND_ROOT_PATH",
    "REGISTRY_VIEW", "BYPASS_PROVIDER",
})  # fmt: skip


@dataclass(frozen=True)
class FoundPackage:
    word: Word
    """The name."""
    is_required: bool
    is_quiet: bool
    components: tuple[Word, ...]
    call: EvaluatedCommand

    @property
    def name(self) -> str:
        return self.word.text


def found_packages(calls: Iterable[EvaluatedCommand]) -> Iterator[FoundPackage]:
    """Yield the calls of find_package, those in loops once for each run."""
    for call in calls:
        if call.name in ("find_package", "gz_find_package", "ign_find_package") and call.words:
            texts, components, listing = set(call.texts[1:]), [], False
            for word in call.words[1:]:
                if word.text in FIND_KEYWORDS:
                    listing = word.text in ("COMPONENTS", "OPTIONAL_COMPONENTS", "REQUIRED")
                elif listing:
                    components.append(word)
            yield FoundPackage(call.words[0], "REQUIRED" in texts, "QUIET" in texts, tuple(components), call)

"""The targets that each source file of a package is compiled into."""

from __future__ import annotations

from collections.abc import Sequence
from functools import cached_property

from ...languages.cmake.evaluated_command import EvaluatedCommand, path_in_package
from ...languages.cmake.targets import Target
from ...languages.cmake.values import UNKNOWN, Word
from ...light_dataclasses import dataclass
from ...package.cmake.cmake_project import CMake
from ...package.cmake.referenced_paths import sources_in


@dataclass(frozen=True)
class SourceTargets:
    cmake: CMake

    @cached_property
    def _sources(self) -> dict[str, tuple[frozenset[str], bool]]:
        """Target → its sources in the package, and whether these are all that it has."""
        found: dict[str, tuple[frozenset[str], bool]] = {}
        added: dict[str, list[EvaluatedCommand]] = {}
        for call in self.cmake.named("target_sources"):
            added.setdefault(call.texts[0] if call.words else "", []).append(call)
        for target in self.cmake.targets:
            paths, complete = located_all(target.sources, target.call)
            if target.folder is not None:
                below, known = self.below(target)
                paths, complete = paths | below, complete and known
            for call in added.get(target.name, ()):
                more, known = located_all(sources_in(call), call)
                paths, complete = paths | more, complete and known
            if "" in added or any(UNKNOWN in name for name in added):
                complete = False
            before, known = found.get(target.name, (frozenset(), True))
            found[target.name] = before | paths, complete and known
        return found

    def below(self, target: Target) -> tuple[frozenset[str], bool]:
        """Return what a target takes of a folder."""
        assert target.folder is not None
        folder = path_in_package(target.folder.text, target.call.folder)
        return (
            frozenset() if folder is None else frozenset(self.cmake.package_files.below(folder))
        ), folder is not None

    def targets_of(self, path: str) -> frozenset[str]:
        """Return the names of the targets that a file is compiled into, as far as they are known."""
        return frozenset(name for name, (paths, _) in self._sources.items() if path in paths and UNKNOWN not in name)

    def is_complete(self, target: str) -> bool:
        """Return whether all sources of a target are known and in the package."""
        return target in self._sources and self._sources[target][1]


def located_all(words: Sequence[Word], call: EvaluatedCommand) -> tuple[frozenset[str], bool]:
    """Return the paths in the package that some words name, and whether these are all."""
    paths = [None if word.maybe else path_in_package(word.text, call.folder) for word in words]
    return frozenset(path for path in paths if path), None not in paths

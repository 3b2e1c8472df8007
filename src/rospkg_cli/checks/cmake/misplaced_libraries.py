"""Shared libraries that are installed where no loader looks: ament puts `lib` alone into LD_LIBRARY_PATH."""

from __future__ import annotations

import posixpath
from collections.abc import Iterator
from functools import cached_property

from ...languages.cmake.targets import Target
from ...languages.cmake.values import Word
from ...light_dataclasses import dataclass
from ...package.cmake.artifacts import Artifacts
from ...package.cmake.cmake_project import CMake
from ...package.cmake.library_uses import LibraryUses
from ...package.cmake.target_links import TargetLinks
from ...package.cmake.uninstalled_target import TargetUse

LOADER = "LD_LIBRARY_PATH"
HOOKS = (".dsv", ".dsv.in", ".sh", ".sh.in", ".bash", ".bash.in", "launch.py")
"""Files that set the environment of programs."""


@dataclass(frozen=True)
class MisplacedLibrary:
    word: Word
    """Where a rule installs it."""
    place: str
    needed_by: TargetUse

    @property
    def fault(self) -> str:
        return f"the library `{self.word.text}` is installed into `{self.place}`, where no loader looks"

    def idle_sentence(self, why: str) -> str:
        """What is said where it is not certain that anything needs it when it starts."""
        return f"{self.fault}: `{self.needed_by.name}`, which is linked with it, {why}; use `lib`"

    @property
    def sentence(self) -> str:
        is_component = self.needed_by.user == "component"
        user = "the component `{}`" if is_component else "`{}`, which is linked with it,"
        return f'{self.fault}: {user.format(self.needed_by.name)} ends with "cannot open shared object"; use `lib`'


@dataclass(frozen=True)
class MisplacedLibraries:
    cmake: CMake

    def all(self) -> Iterator[MisplacedLibrary]:
        """Yield the libraries of which every rule is known and none installs them into lib/; an RPATH may find them."""
        uses = LibraryUses(self.cmake, TargetLinks(self.cmake))
        for target in self.cmake.targets if not self.has_rpath else ():
            places = self.places.get(target.name, [])
            is_shared = not target.call.maybe and uses.links.shared(target)
            if is_shared and places and all(map(is_wrong, places)) and (user := uses.loaded_by(target)) is not None:
                word, place = places[0]
                yield MisplacedLibrary(word, place or "", user)

    @cached_property
    def places(self) -> dict[str, list[tuple[Word, str | None]]]:
        """Library → where its rules install it; None where that is unknown or depends on a condition."""
        found: dict[str, list[tuple[Word, str | None]]] = {}
        artifacts = Artifacts(self.cmake)
        for rule in self.cmake.installs:
            for word in rule.items if rule.kind == "TARGETS" else ():
                target: Target | None = self.cmake.target(word.text)
                if target is not None and target.is_library:
                    place = None if rule.call.maybe else artifacts.destination(rule, target)
                    found.setdefault(target.name, []).append((word, place))
        return found

    @cached_property
    def has_rpath(self) -> bool:
        """Whether a command or an environment hook sets where programs look for libraries, or may."""
        files = self.cmake.package_files
        hooks = (path for path in files.paths if path.endswith(HOOKS))
        is_set = any("RPATH" in text for each in self.cmake.calls for text in each.texts)
        return self.cmake.reads_unknown_files or is_set or any(LOADER in files.readable_text(path) for path in hooks)


def is_wrong(place: tuple[Word, str | None]) -> bool:
    """Return whether a rule surely installs below lib/, into share/ or into bin/, and not for Python."""
    folder = posixpath.normpath(place[1] or "")
    return folder == "bin" or (folder.startswith(("lib/", "share/")) and not folder.startswith("lib/python"))

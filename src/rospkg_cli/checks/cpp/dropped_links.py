"""Libraries that the linker leaves out of a program, as no code of it may call them: `--as-needed` is Ubuntu's way."""

from __future__ import annotations

import posixpath
from functools import cached_property

from ...languages.cpp.file import CppFile
from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...package.cmake.cmake_package import CMakePackage
from ...package.cmake.target_links import TargetLinks
from ..cmake.misplaced_libraries import MisplacedLibraries, MisplacedLibrary, is_wrong
from ..cmake.source_targets import SourceTargets
from ..depends.compiled_sources import HEADERS, Inclusions

OTHERWISE = regex(r"no-as-needed|(?i:precompile_headers|(?<![\w-])-include\b)")
"""What a CMake file holds that keeps such libraries, or includes headers of its own accord."""


@dataclass(frozen=True)
class DroppedLinks:
    package: CMakePackage
    sources: tuple[CppFile, ...]

    def has(self, found: MisplacedLibrary) -> bool:
        """Return whether it is not certain that anything needs a library when it starts.

        A program needs one whose header it certainly includes: one that stands with the library's sources. How a
        library that lies beside is loaded is its host's affair.
        """
        cmake, offered = self.package.cmake, self.offered(found.word.text)
        if found.needed_by.user == "component":
            return False
        linked = [link.target for link in TargetLinks(cmake).with_word(found.word.text) if not link.package]
        users = list(filter(self.is_started, linked))
        is_kept = any(OTHERWISE.search(file.source.text) for file in cmake.files)
        return not any(is_kept or not offered.isdisjoint(self.opened(user)) for user in users)

    def includes_nothing(self, found: MisplacedLibrary) -> bool:
        """Return whether what is linked with a library surely includes none of its headers."""
        offered, user = self.offered(found.word.text), found.needed_by.name
        reached = self.inclusions.reached(self.sources_of(user)) if self.compiled.is_complete(user) else set[str]()
        return bool(offered) and bool(reached) and offered.isdisjoint(reached)

    def offered(self, library: str) -> set[str]:
        """Return the headers that the sources of a library include, or that are called like one of them."""
        paths = self.sources_of(library)
        stems = {posixpath.splitext(posixpath.basename(path))[0] for path in paths}
        headers = {path for path in self.inclusions.files if path.endswith(HEADERS)}
        alike = {path for path in headers if posixpath.splitext(posixpath.basename(path))[0] in stems}
        return alike | (self.inclusions.reached(paths) & headers)

    def is_started(self, target: str) -> bool:
        """Return whether a program or a library surely gets loaded by the package, or by others who link it."""
        made = self.package.cmake.target(target)
        is_component = any(each.target.text == target for each in self.package.cmake.components)
        if made is None or made.is_executable or is_component:
            return True
        places = MisplacedLibraries(self.package.cmake).places.get(target, [])
        return "MODULE" not in made.options and not (places and all(map(is_wrong, places)))

    def opened(self, target: str) -> set[str]:
        """Return the files that the compiler surely opens for a target."""
        return self.certain.reached(self.sources_of(target))

    def sources_of(self, target: str) -> set[str]:
        return {path for path in self.inclusions.files if target in self.compiled.targets_of(path)}

    @cached_property
    def compiled(self) -> SourceTargets:
        return SourceTargets(self.package.cmake)

    @cached_property
    def inclusions(self) -> Inclusions:
        return Inclusions({file.path: file for file in self.sources})

    @cached_property
    def certain(self) -> Inclusions:
        return Inclusions(self.inclusions.files, unconditional=True)

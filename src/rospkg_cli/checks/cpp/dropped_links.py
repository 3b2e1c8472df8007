"""Libraries that the linker leaves out of a program, as no code of it may call them: `--as-needed` is Ubuntu's way."""

from __future__ import annotations

from functools import cached_property

from ...languages.cpp.file import CppFile
from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...package.cmake.cmake_package import CMakePackage
from ...package.cmake.target_links import TargetLinks
from ..cmake.misplaced_libraries import MisplacedLibrary
from ..cmake.source_targets import SourceTargets
from ..depends.compiled_sources import HEADERS, Inclusions

OTHERWISE = regex(r"no-as-needed|(?i:precompile_headers|(?<![\w-])-include\b)")
"""What a CMake file holds that keeps such libraries, or includes headers of its own accord."""


@dataclass(frozen=True)
class DroppedLinks:
    package: CMakePackage
    sources: tuple[CppFile, ...]

    def has(self, found: MisplacedLibrary) -> bool:
        """Return whether all that is linked with a library includes none of its headers, as far as that is known.

        These are the headers that its own sources include; without any it is unknown how others call it.
        """
        cmake, library = self.package.cmake, found.word.text
        is_open = cmake.reads_unknown_files or any(OTHERWISE.search(file.source.text) for file in cmake.files)
        if is_open or found.needed_by.user == "component":
            return False
        offered = {path for path in self.reached(library) or () if path.endswith(HEADERS)}
        users = [self.reached(link.target) for link in TargetLinks(cmake).with_word(library) if not link.package]
        return bool(offered) and all(user is not None and offered.isdisjoint(user) for user in users)

    def reached(self, target: str) -> set[str] | None:
        """Return the files of the package that a target is compiled of; None where one is not known."""
        paths = {path for path in self.inclusions.files if target in self.compiled.targets_of(path)}
        return self.inclusions.reached(paths) if paths and self.compiled.is_complete(target) else None

    @cached_property
    def compiled(self) -> SourceTargets:
        return SourceTargets(self.package.cmake)

    @cached_property
    def inclusions(self) -> Inclusions:
        return Inclusions({file.path: file for file in self.sources})

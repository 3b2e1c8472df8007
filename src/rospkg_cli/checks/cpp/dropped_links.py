"""Libraries that the linker leaves out of a program, as no code of it may call them: `--as-needed` is Ubuntu's way."""

from __future__ import annotations

import posixpath
from functools import cached_property

from ...languages.cpp.file import CppFile
from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...package.cmake.cmake_package import CMakePackage
from ...package.cmake.target_links import TargetLinks
from ...package.cmake.uninstalled_targets import UninstalledTarget
from ...package.workspace import Workspace
from ..cmake.misplaced_libraries import MisplacedLibraries, MisplacedLibrary, is_wrong
from ..cmake.source_targets import SourceTargets
from ..depends.compiled_sources import HEADERS, Inclusions

OTHERWISE = regex(r"no-as-needed|(?i:precompile_headers|(?<![\w-])-include\b)")
"""What a CMake file holds that keeps such libraries, or includes headers of its own accord."""


@dataclass(frozen=True)
class DroppedLinks:
    package: CMakePackage
    sources: tuple[CppFile, ...]
    workspace: Workspace

    def has(self, found: MisplacedLibrary) -> bool:
        """Return whether it is not certain that anything needs a library that is installed elsewhere."""
        return found.needed_by.user != "component" and self.is_idle(found.word.text)

    def why_idle(self, found: UninstalledTarget) -> str:
        """Return why nothing may need a library that is not installed; "" where something does, or that is unknown."""
        needed, name = found.needed_by, found.target.name
        is_linked = needed is not None and needed.user == "linked target" and not found.stops
        if not (is_linked and needed is not None and self.compiled.is_complete(name) and self.is_idle(name)):
            return ""
        has_all = self.has_all_of(needed.name, name)
        return "compiles its sources itself" if has_all else "seems to include none of its headers"

    def is_idle(self, library: str) -> bool:
        """Return whether it is not certain that anything needs a library when it starts.

        A program needs one whose header it certainly includes: one that stands with the library's sources, if it does
        not compile all of these itself. How a library that lies beside is loaded is its host's affair.
        """
        cmake, offered = self.package.cmake, self.offered(library)
        linked = [link.target for link in TargetLinks(cmake).with_word(library) if not link.package]
        users = [each for each in linked if self.is_started(each) and not self.has_all_of(each, library)]
        is_kept = any(OTHERWISE.search(file.source.text) for file in cmake.files)
        return not any(is_kept or not offered.isdisjoint(self.opened(user)) for user in users)

    def has_all_of(self, user: str, library: str) -> bool:
        """Return whether a target compiles each source of a library itself: the linker asks the library for nothing."""
        own = self.sources_of(library)
        return bool(own) and self.compiled.is_complete(library) and own <= self.sources_of(user)

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

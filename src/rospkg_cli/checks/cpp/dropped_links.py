"""Libraries that the linker may leave out of a program that calls nothing of them (`--as-needed`, as on Ubuntu)."""

from __future__ import annotations

import posixpath
from functools import cached_property

from ...languages.cpp.code_text import code_text
from ...languages.cpp.file import CppFile
from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...package.cmake.cmake_package import CMakePackage
from ...package.cmake.library_uses import LibraryUses
from ...package.cmake.target_links import TargetLinks
from ...package.cmake.uninstalled_target import UninstalledTarget
from ...package.workspace import Workspace
from ..cmake.consumers import Consumers
from ..cmake.misplaced_libraries import MisplacedLibraries, MisplacedLibrary, is_wrong
from ..cmake.source_targets import SourceTargets
from ..depends.header_inclusions import HEADERS, Inclusions
from ..depends.ros1_headers import Ros1Headers
from ..depends.ros1_sources import Ros1Sources

OTHERWISE = regex(r"no-as-needed|(?i:precompile_headers|(?<![\w-])-include\b)")
"""What a CMake file holds that keeps such libraries, or includes headers of its own accord."""
DECLARES = regex(r"\)[\w\s]*;|\bextern\b|\bstatic\s+(?!(?:inline|const|constexpr)\b)")
"""What a header holds that declares a function, or a value, which a source defines."""


@dataclass(frozen=True)
class DroppedLinks:
    package: CMakePackage
    sources: tuple[CppFile, ...]
    workspace: Workspace
    consumers: Consumers

    def why_unmet(self, found: UninstalledTarget) -> str:
        """Return why nothing is known to miss a target that is not installed, as a whole sentence; "" where it is."""
        needed, old = found.needed_by, self.ros1.stopping(found.target.name)
        if found.stops:
            return ""
        if old is not None:
            return old.sentence
        if needed is not None and needed.user == "parameter library":
            return "; nothing here links it"
        is_promised = needed is not None and needed.user == "exporter"
        is_met = bool(self.consumers.finders) or self.consumers.are_elsewhere or self.is_linked(found)
        return "" if is_met or not is_promised else "; no package here looks for this one"

    def is_linked(self, found: UninstalledTarget) -> bool:
        """Return whether an installed target of the package surely needs a library, not only users of its exports."""
        cmake = self.package.cmake
        user = LibraryUses(cmake, TargetLinks(cmake)).loaded_by(found.target)
        return user is not None and (user.user == "component" or not self.is_idle(found.target.name))

    @cached_property
    def ros1(self) -> Ros1Sources:
        headers = Ros1Headers(self.package.facts, self.package.cmake.package_files, self.workspace)
        return Ros1Sources(headers, self.package.cmake, self.sources)

    def why_misplaced(self, found: MisplacedLibrary) -> str:
        """Return why nothing may need a library that is installed elsewhere; "" where something does."""
        name, user = found.word.text, found.needed_by
        if user.user == "component" or not self.is_idle(name):
            return ""
        if self.shares_source(user.name, name):
            return "compiles sources of it itself"
        return "includes none of its headers" if self.includes_nothing(user.name, name) else "may not find it"

    def why_idle(self, found: UninstalledTarget) -> str:
        """Return why nothing may need a library that is not installed; "" where something does, or that is unknown."""
        needed, name = found.needed_by, found.target.name
        is_linked = needed is not None and needed.user == "linked target" and not found.stops
        if not (is_linked and needed is not None and self.compiled.is_complete(name) and self.is_idle(name)):
            return ""
        has_own = self.shares_source(needed.name, name)
        return "compiles sources of it itself" if has_own else "seems to include none of its headers"

    def is_idle(self, library: str) -> bool:
        """Return whether it is not certain that anything needs a library when it starts.

        A program needs one whose header it certainly includes: one that stands with the library's sources, if it
        compiles none of these itself. A library in the same folder may be loaded by its host in another way.
        """
        cmake, offered = self.package.cmake, self.offered(library)
        linked = [link.target for link in TargetLinks(cmake).with_word(library) if not link.package]
        users = [each for each in linked if self.is_started(each) and not self.shares_source(each, library)]
        is_kept = any(OTHERWISE.search(file.source.text) for file in cmake.files)
        return not any(is_kept or not offered.isdisjoint(self.opened(user)) for user in users)

    def shares_source(self, user: str, library: str) -> bool:
        """Return whether a target compiles a source of a library itself, as `#include "core.cpp"` does as well.

        It has what is defined there, and the linker asks the library for nothing of it.
        """
        return not self.sources_of(library).isdisjoint(self.inclusions.reached(self.sources_of(user)))

    def includes_nothing(self, user: str, library: str) -> bool:
        """Return whether what is linked with a library surely includes none of its headers."""
        offered = self.offered(library)
        reached = self.inclusions.reached(self.sources_of(user)) if self.compiled.is_complete(user) else set[str]()
        return bool(offered) and bool(reached) and offered.isdisjoint(reached)

    def offered(self, library: str) -> set[str]:
        """Return the headers that the sources of a library include, or that are called like one of them.

        One without a function that is defined elsewhere, as a header of numbers, needs no code of the library.
        """
        paths = self.sources_of(library)
        stems = {posixpath.splitext(posixpath.basename(path))[0] for path in paths}
        headers = {path for path in self.inclusions.files if path.endswith(HEADERS)}
        alike = {path for path in headers if posixpath.splitext(posixpath.basename(path))[0] in stems}
        every = alike | (self.inclusions.reached(paths) & headers)
        return {path for path in every if DECLARES.search(code_text(self.inclusions.files[path].source.text))}

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

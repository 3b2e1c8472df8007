"""The ROS packages that a CMake target is linked with, directly or by way of other targets of the package."""

from __future__ import annotations

from functools import cached_property

from ...languages.cmake.values import UNKNOWN, Word
from ...light_dataclasses import dataclass
from ...package.cmake.cmake_project import CMake
from ...package.cmake.set_variables import WHOLE_REFERENCE, SetVariables
from ...package.cmake.target_links import TargetLink, TargetLinks
from ...package.workspace import Workspace
from ...ros.aliases import keys_for_cmake
from ...ros.names import NameKind
from ...suggest import near_names
from ..cmake.exported_names import BY_MACRO
from ..cmake.name_slips import LEAST
from .brought_by_links import is_of_interfaces
from .header_folders import HeaderFolders
from .linked_at_run_time import VARIABLE
from .own_typesupport import with_own_interfaces


@dataclass(frozen=True)
class LinkedPackages:
    cmake: CMake
    workspace: Workspace

    def of(self, name: str) -> set[str] | None:
        """Return the packages of a target, or whose headers lie in its include directories; None where unknown."""
        found: set[str] = set()
        waiting, seen = [(name, True)], set[str]()
        while waiting:
            target, is_first = waiting.pop()
            if target in seen:
                continue
            seen.add(target)
            made, folders = self.cmake.target(target), self.folders.of_target(target)
            generated = with_own_interfaces(self.cmake, target, self.links.of(target))
            if folders is None or generated is None:
                return None
            found.update(folders, generated)
            found |= BY_MACRO.get(made.call.name, frozenset()) if made else frozenset()
            for link in self.links.of(target):
                if is_first or link.is_public:
                    own = self.links.own(link.word.text) if not link.package else None
                    packages = self.packages_of(link) if own is None else []
                    if packages is None:
                        return None
                    found.update(packages)
                    waiting += [(own.name, False)] if own is not None else []
        return found

    def packages_of(self, link: TargetLink) -> list[str] | None:
        """Return the ROS packages that an argument of target_link_libraries() stands for; None where unknown."""
        text, cmake = link.word.text, self.cmake
        if named := VARIABLE.fullmatch(cmake.source_text(link.word).strip('"')):
            return self.folders.behind_variables(named[1])
        if self.variables.empty_variable(link.word) or self.is_library(link.word):
            return []
        if UNKNOWN in text or "$<" in text or not link.word.is_known:
            return None
        name = text.partition("::")[0]
        if self.workspace.kind_of(name) is NameKind.PACKAGE:
            return [name]
        if link.package and is_of_interfaces(name):
            return [name]
        if len(text) >= LEAST and near_names(text, self.made):
            return None
        is_library = not link.package and "::" not in text
        return [] if is_library or keys_for_cmake(name) else None

    @cached_property
    def made(self) -> frozenset[str]:
        """The targets that the package makes: a link that is nearly one of them is a misspelt one (CMK110)."""
        return frozenset(each.name for each in self.cmake.targets if not each.call.testing)

    def is_library(self, word: Word) -> bool:
        """Return whether a word is a variable that find_library() sets to the path of a library."""
        named = WHOLE_REFERENCE.fullmatch(self.cmake.source_text(word).strip('"'))
        return named is not None and named[1] in self.searched

    @cached_property
    def searched(self) -> frozenset[str]:
        """The variables that find_library() sets."""
        return frozenset(call.texts[0] for call in self.cmake.named("find_library") if call.texts)

    @cached_property
    def links(self) -> TargetLinks:
        return TargetLinks(self.cmake)

    @cached_property
    def folders(self) -> HeaderFolders:
        return HeaderFolders(self.cmake, self.workspace)

    @cached_property
    def variables(self) -> SetVariables:
        return SetVariables(self.cmake)

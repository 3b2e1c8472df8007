"""Packages whose include directories CMake adds to targets: `include_directories(${tf2_INCLUDE_DIRS})`."""

from __future__ import annotations

from functools import cache, cached_property

from ...languages.cmake.evaluated_command import EvaluatedCommand, path_in_package
from ...languages.cmake.values import UNKNOWN, Word
from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...package.cmake.cmake_project import CMake
from ...package.workspace import Workspace
from ...ros.names import NameKind
from ...ros.read_table import rows
from .build_tools_of_cmake import ASKS_PKG_CONFIG

FOLDERS = regex(r"\$\{([\w.+-]+?)_INCLUDE_?DIRS?\}")
INSTALLED = regex(r"/include/(\w+)/?(?=>|$)")
"""The folder of a package's headers in an installation."""
SET_BY_NOBODY = frozenset({"ament", "catkin"})
"""Names for which no `find_package()` of ROS 2 sets variables."""
WORDS = frozenset({"AFTER", "BEFORE", "SYSTEM"})


@dataclass(frozen=True)
class HeaderFolders:
    cmake: CMake
    workspace: Workspace

    @cached_property
    def for_all(self) -> frozenset[str] | None:
        """The packages whose include directories commands add to all targets; None where unknown."""
        found: set[str] = set()
        for call in self.cmake.named("include_directories", "link_libraries"):
            for word in call.words:
                packages = self.packages_of(word, call) if call.name == "include_directories" else None
                if packages is None:
                    return None
                found.update(packages)
        return frozenset(found)

    def packages_of(self, word: Word, call: EvaluatedCommand) -> list[str] | None:
        """Return the ROS packages whose headers a folder holds: `tf2` for `${tf2_INCLUDE_DIRS}`, none in the package
        itself and for `${Boost_INCLUDE_DIRS}`; None where they are unknown."""
        if word.is_known:
            is_own = word.text in WORDS or path_in_package(word.text, call.folder) is not None
            return [] if is_own else None
        named = FOLDERS.fullmatch(self.cmake.source_text(word).strip('"'))
        if named is None:
            return None
        asked = {each.texts[0] for each in self.cmake.named(*ASKS_PKG_CONFIG) if each.texts}
        return [] if named[1] in asked else self.behind_variables(named[1])

    def behind_variables(self, name: str) -> list[str]:
        """Return the package whose variables begin with a name; nothing for libraries of the system (`YAML_CPP`)."""
        if self.workspace.kind_of(name) is NameKind.PACKAGE:
            return [name]
        return [] if plain(name) in libraries_of_cmake() or name in SET_BY_NOBODY else [name]

    def of_target(self, target: str) -> list[str] | None:
        """Return the packages whose include directories commands add to a target; None where they are unknown."""
        found: list[str] = []
        for call in self.cmake.named("target_include_directories", "target_sources", "set_target_properties"):
            is_of_target = call.texts[:1] == (target,)
            if call.name != "target_include_directories":
                if is_of_target and any("INCLUDE_DIR" in text or UNKNOWN in text for text in call.texts):
                    return None
                continue
            for word in call.words[1:] if is_of_target else ():
                packages = self.packages_of(word, call) if UNKNOWN in word.text else INSTALLED.findall(word.text)
                if packages is None:
                    return None
                found += packages
        return found


def plain(name: str) -> str:
    return name.lower().replace("-", "").replace("_", "")


@cache
def libraries_of_cmake() -> frozenset[str]:
    """Return what `find_package()` calls libraries of the system, in small letters without `-` and `_`."""
    return frozenset(map(plain, rows("cmake.txt")))

"""Libraries that people install by hand, or that CMake takes from a folder of its own, and not from apt or pip."""

from __future__ import annotations

from collections.abc import Iterable
from functools import cached_property

from ...files import PackageFiles
from ...languages.cmake.evaluated_command import path_in_package
from ...light_dataclasses import dataclass
from ...package.cmake.cmake_project import CMake
from ...ros.libraries import keys_of_header
from ...ros.names import Names
from ..cmake.commented_installs import said_in
from .commented_installs import is_said_in
from .hand_installs import BY_PAGE, HandInstalls
from .included_packages import IncludedPackage
from .own_places import ELSEWHERE, has_include_folder
from .places_outside_apt import OUTSIDE_APT, place_outside_apt

BY_COMMENT = "; a comment here says to install it by hand, and the key may bring another version"


@dataclass(frozen=True)
class LibrariesByHand:
    files: PackageFiles
    cmake: CMake
    index: Names

    def why(self, cmake: str, names: Iterable[str], headers: Iterable[str] = ()) -> str:
        """Return the end of a message that says where a library comes from, if not from its key; "" where nothing does.

        `cmake` is its name in CMake, `names` are packages and keys that provide it, `headers` those that are included.
        """
        keys = [each for each in names if self.index.is_key(each)]
        every = (cmake, *keys, *headers) if keys else ()
        if place := place_outside_apt(self.cmake, every) if keys else "":
            return OUTSIDE_APT.format(place)
        if keys and HandInstalls(self.files).has(every):
            return BY_PAGE
        if keys and is_said_in("\n".join(map(said_in, self.cmake.files)), every):
            return BY_COMMENT
        return ELSEWHERE if keys and has_include_folder([*headers], self.cmake) else ""

    def may_be_submodule(self, each: IncludedPackage) -> bool:
        """Return whether all its headers are of libraries, and CMake looks into a submodule that is not checked out."""
        return self.opens_submodule and all(keys_of_header(use.header) for use in each.uses)

    @cached_property
    def opens_submodule(self) -> bool:
        calls = self.cmake.named("include_directories", "target_include_directories", "add_subdirectory")
        paths = (path_in_package(word.text, call.folder) for call in calls for word in call.words)
        return any(path and self.files.absent.submodule_of(path) for path in paths)

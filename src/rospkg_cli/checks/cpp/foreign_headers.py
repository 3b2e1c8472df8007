"""Headers that C++ includes from a folder of no package: a misspelt one, or one of ROS 1 (CMK201)."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cached_property
from itertools import islice
from typing import Literal

from ...languages.cpp.file import CppFile, IncludeDirective
from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...source import Span
from ..cmake.name_slips import digits
from ..depends.compiled_sources import compiled_sources
from ..depends.ros1_sources import Ros1Use
from ..fault import Level
from .missing_headers import MissingHeaders
from .near_header_folders import NearHeaderFolders

PREFIX = regex(r"/opt/ros/(?:hydro|indigo|jade|kinetic|lunar|melodic|noetic)\b")
ROS_1 = frozenset({"catkin", "roscpp"})


@dataclass(frozen=True, slots=True)
class ForeignHeader:
    path: str
    span: Span
    header: str
    kind: Literal["folder", "ros1", "both", "unsure"]
    """A folder of no package, a header of ROS 1 (in a package that looks for ROS 1 too), or a name that may be one."""
    instead: str
    """The header that is intended, or that ROS 2 has; "" where there is none."""
    level: Level
    """How bad it is, by who compiles the file."""
    behind: Ros1Use | None = None
    """What of ROS 1 ends the build of all targets with the file before this include."""


@dataclass(frozen=True)
class ForeignHeaders:
    headers: MissingHeaders
    """The package with its own headers, and those of the workspace."""

    def all(self) -> Iterator[ForeignHeader]:
        """Yield each include in what is compiled or installed whose header is certainly somewhere else.

        Headers of ROS 1 are reported in files that the build compiles, one a file: others were not yet ported. Where
        CMake looks for ROS 1 itself, and package.xml declares it, they are intended.
        """
        package = self.headers.package
        if not package.is_ament or (self.is_for_both and not ROS_1.isdisjoint(self.folders.declared)):
            return
        found = self.in_files()
        yield from islice((each for each in found if each.kind == "both"), 1) if self.is_for_both else found

    def in_files(self) -> Iterator[ForeignHeader]:
        package, sources = self.headers.package, self.headers.sources
        for source, role in compiled_sources(package.cmake, sources):
            if role == "aside" or "__has_include" in source.source.text or source.path in self.headers.guarded:
                continue
            found = [
                foreign
                for each in source.includes
                if not each.is_conditional and "/" in each.path
                for foreign in self.judged(source, each)
                if not self.headers.known.is_there(each.path)  # last, as it looks into all packages
            ]
            old = sorted((each for each in found if each.kind != "folder"), key=lambda each: each.kind == "unsure")
            yield from (each for each in found if each.kind == "folder")
            yield from old[:1] if source.path in self.headers.compiled else ()

    @cached_property
    def is_for_both(self) -> bool:
        """Whether CMake looks for ROS 1, links its libraries or goes into its folders, as that of a bridge does."""
        cmake = self.headers.package.cmake
        texts = (text for call in cmake.calls for text in call.texts)
        is_found = not ROS_1.isdisjoint(each.name for each in cmake.packages)
        return is_found or any(text in ROS_1 or PREFIX.match(text) for text in texts)

    def judged(self, source: CppFile, each: IncludeDirective) -> Iterator[ForeignHeader]:
        """Yield what is wrong with one include: a header of ROS 1, or a folder that no package has."""
        level = self.headers.harm_in(source.path)
        if (old := self.headers.ros1.headers.find(each.path)) is not None:
            kind: Literal["ros1", "both", "unsure"] = "both" if self.is_for_both else "ros1"
            kind = kind if old.is_certain else "unsure"
            yield ForeignHeader(source.path, each.span, each.path, kind, old.meant, level if kind == "ros1" else "info")
            return
        near = self.headers.ros1.headers.with_kind(each.path) or self.folders.in_right_folder(each.path)
        if near:
            is_other = digits(folder_of(near)) != digits(folder_of(each.path))
            level = "warning" if is_other and level == "error" else level
            behind = self.headers.ros1.stopping_all([source.path])
            yield ForeignHeader(source.path, each.span, each.path, "folder", near, level, behind)

    @cached_property
    def folders(self) -> NearHeaderFolders:
        headers = self.headers
        return NearHeaderFolders(headers.package, headers.sources, headers.workspace, headers.known)


def folder_of(header: str) -> str:
    return header.partition("/")[0]

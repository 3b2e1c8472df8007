"""Headers of the package, or of another one of the workspace, that C++ includes and that do not exist (CMK201)."""

from __future__ import annotations

import posixpath
from collections.abc import Iterator
from functools import cached_property

from ...languages.cpp.file import CppFile, IncludeDirective
from ...light_dataclasses import dataclass
from ...package.cmake.cmake_package import CMakePackage
from ...package.cmake.made_headers import HEADERS
from ...package.workspace import Workspace
from ...ros.headers import LIBRARIES, SHARED
from ...source import Span
from ..depends.compiled_sources import compiled_sources, harm_in, own_compiled
from ..depends.conditional_includes import only_under_conditions
from ..depends.ros1_headers import Ros1Headers
from ..depends.ros1_sources import Ros1Sources, Ros1Use
from ..fault import Level
from .known_headers import KnownHeaders, may_be_written
from .near_headers import header_next_to, is_slip, near_header, without_itself
from .unmet_headers import is_unmet, may_be_for


@dataclass(frozen=True, slots=True)
class MissingHeader:
    path: str
    span: Span
    header: str
    owner: str
    """The package that should have it."""
    near: str
    """The header that is intended; "" where none is near."""
    level: Level
    """How bad it is, by who compiles the file."""
    behind: Ros1Use | None = None
    """What of ROS 1 ends the build of all targets with the file."""


@dataclass(frozen=True)
class MissingHeaders:
    package: CMakePackage
    sources: tuple[CppFile, ...]
    workspace: Workspace

    def all(self) -> Iterator[MissingHeader]:
        """Yield each include of a missing header in what is compiled or installed, for ROS 2."""
        for source, role in compiled_sources(self.package.cmake, self.sources):
            is_open = role == "aside" or "__has_include" in source.source.text or is_for_ros1(source)
            if is_open or source.path in self.guarded:
                continue
            for each in source.includes:
                if not each.is_conditional and may_be_written(each.path) and (found := self.missing(source, each)):
                    owner, near = found
                    if not near and not each.path.endswith(HEADERS):
                        continue  # `.inc`, `.def`: anything may make it
                    level, behind = self.harm_in(source.path), self.ros1.stopping_all([source.path])
                    yield MissingHeader(source.path, each.span, each.path, owner, near, level, behind)

    def missing(self, source: CppFile, each: IncludeDirective) -> tuple[str, str] | None:
        """Return the package that lacks a header, and the header that is near; None where it may exist."""
        known, (folder, slash, _) = self.known, each.path.partition("/")
        if known.is_there(each.path):
            return None
        if not slash:
            paths = self.package.cmake.package_files.paths
            near = None if each.is_angled else header_next_to(source.path, each.path, paths)
            return (self.package.facts.name, near) if near and known.knows_own(each.path) else None
        is_open = folder in LIBRARIES or folder in SHARED  # the library's headers are outside of the workspace
        if folder == self.package.facts.name:
            is_open = is_open or known.may_have_more
            near = near_header(each.path, without_itself(source.path, known.own), is_open)
            near = near if self.may_mean(source, each.path, near) else ""
            return (folder, near) if known.knows_own(each.path) and (near or not is_open) else None
        if (facts := self.workspace.named(folder)) is None:
            return None
        near = near_header(each.path, facts.header_files, is_open or not facts.knows("header_files"))
        return (folder, near) if near or (not is_open and known.has_all(facts, folder)) else None

    def may_mean(self, source: CppFile, header: str, near: str) -> bool:
        """Return whether a file may include `near` in place of `header`: the name is a slip, or it uses its classes."""
        if not near or is_slip(header, near):
            return True
        found = self.known.by_name.get(posixpath.basename(near), ())
        paths = [path for path in found if f"/{path}".endswith(f"/{near}")]
        files = [file for file in self.sources if file.path in paths]
        return len(files) != 1 or may_be_for(source, files[0])

    def harm_in(self, path: str) -> Level:
        """Return how bad a missing header in a file is."""
        package = self.package
        if is_unmet(package.cmake, self.sources, path, self.workspace, package.facts.name):
            return "info"
        return harm_in(package.cmake, self.sources, path)

    @cached_property
    def known(self) -> KnownHeaders:
        return KnownHeaders(self.package, self.workspace)

    @cached_property
    def ros1(self) -> Ros1Sources:
        package = self.package
        headers = Ros1Headers(package.facts, package.cmake.package_files, self.workspace)
        return Ros1Sources(headers, package.cmake, self.sources)

    @cached_property
    def guarded(self) -> frozenset[str]:
        """The files that others include under a condition alone: the compiler may never see them."""
        return only_under_conditions(self.package.cmake, self.sources)

    @cached_property
    def compiled(self) -> set[str]:
        return own_compiled(self.package.cmake, self.sources) or set()


def is_for_ros1(source: CppFile) -> bool:
    """Return whether a file includes ROS 1 itself: one for both versions leaves the choice to the preprocessor."""
    return any(each.path == "ros/ros.h" and not each.is_conditional for each in source.includes)

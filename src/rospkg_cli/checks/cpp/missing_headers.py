"""Headers of the package, or of another one of the workspace, that C++ includes and that are not there (CMK201)."""

from __future__ import annotations

import posixpath
from collections.abc import Iterable, Iterator
from functools import cached_property

from ...languages.cpp.file import CppFile, IncludeDirective
from ...light_dataclasses import dataclass
from ...package.cmake.cmake_package import CMakePackage
from ...package.cmake.inner_headers import inner_headers
from ...package.cmake.made_headers import HEADERS, made_header_names, may_make_headers
from ...package.package_facts import PackageFacts
from ...package.workspace import Workspace
from ...ros.headers import LIBRARIES, SHARED
from ...ros.interfaces import KINDS, OF_INTERFACES
from ...source import Span
from ...suggest import near_names, nearest
from ..depends.compiled_sources import compiled_sources, harm_in, only_under_conditions, own_compiled
from ..depends.ros1_headers import Ros1Headers
from ..depends.ros1_sources import Ros1Sources, Ros1Use
from ..fault import Level
from .installed_headers import is_installed_header
from .unmet_headers import is_unmet, may_be_for

MADE = (".pb.h", ".pb.hpp", "_generated.h")
"""What compilers of protobuf and flatbuffers write: by hand too, into folders that git ignores."""
LOOKING = (
    "find_package find_path find_library pkg_check_modules pkg_search_module externalproject_add fetchcontent_declare"
).split()
SHORT = 10
"""Letters of a file's name from which two may be wrong."""


@dataclass(frozen=True, slots=True)
class MissingHeader:
    path: str
    span: Span
    header: str
    owner: str
    """The package that should have it."""
    meant: str
    """The header that is near; "" where none is."""
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
                if not each.is_conditional and self.is_header(each.path) and (found := self.missing(source, each)):
                    owner, meant = found
                    if not meant and not each.path.endswith(HEADERS):
                        continue  # `.inc`, `.def`: anything may make it
                    level, behind = self.harm_in(source.path), self.ros1.stopping_all([source.path])
                    yield MissingHeader(source.path, each.span, each.path, owner, meant, level, behind)

    def is_header(self, path: str) -> bool:
        """Return whether a path may be that of a header that people write: interfaces have generated ones."""
        parts = path.split("/")
        is_made = parts[-1].endswith(MADE) or (len(parts) > 2 and parts[1] in KINDS)
        return "." in parts[-1] and not is_made and ".." not in parts

    def missing(self, source: CppFile, each: IncludeDirective) -> tuple[str, str] | None:
        """Return the package that lacks a header, and the one that is near; None where it may be there."""
        folder, slash, _ = each.path.partition("/")
        if self.is_there(each.path):
            return None
        if not slash:
            meant = None if each.is_angled else self.beside(source, each.path)
            return (self.package.facts.name, meant) if meant and self.knows_own(each.path) else None
        is_open = folder in LIBRARIES or folder in SHARED  # the library's headers are outside of the workspace
        if folder == self.package.facts.name:
            is_open = is_open or self.may_make or self.is_of_library
            meant = self.near(each.path, self.others(source, self.own), is_open)
            meant = meant if self.may_mean(source, each.path, meant) else ""
            return (folder, meant) if self.knows_own(each.path) and (meant or not is_open) else None
        if (facts := self.workspace.named(folder)) is None:
            return None
        meant = self.near(each.path, facts.header_files, is_open or not facts.knows("header_files"))
        return (folder, meant) if meant or (not is_open and self.has_all(facts, folder)) else None

    def is_there(self, header: str) -> bool:
        """Return whether a file of the package ends with the path, or a package of the workspace has the header."""
        ends = self.by_name.get(posixpath.basename(header), ())
        wanted = f"/{posixpath.normpath(header)}"
        is_own = header in self.inner or any(f"/{path}".endswith(wanted) for path in ends)
        return is_own or is_installed_header(header, self.workspace)

    @cached_property
    def inner(self) -> frozenset[str]:
        return inner_headers(self.package.cmake)

    def knows_own(self, header: str) -> bool:
        """Return whether the build makes no header of that name, and no folder of git or a submodule lacks it."""
        cmake = self.package.cmake
        expected = cmake.package_files.absent.is_expected
        is_made = posixpath.basename(header) in made_header_names(cmake)
        return not is_made and not expected(f"include/{header}") and not self.is_shared(header)

    def is_shared(self, header: str) -> bool:
        """Return whether another package of the workspace, whose headers are not all known, has the folder."""
        others = (facts for facts in self.workspace.packages if facts.name != self.package.facts.name)
        first = header.partition("/")[0]
        return any(
            not facts.knows("header_files") and any(f"{each}/".startswith(f"{first}/") for each in facts.headers)
            for facts in others
        )

    def has_all(self, facts: PackageFacts, folder: str) -> bool:
        """Return whether all headers of another package are known, and it has some in the folder of its name."""
        has_some = any(each.startswith(f"{folder}/") for each in facts.header_files)
        return has_some and facts.knows("header_files") and not self.is_shared(f"{folder}/")

    def near(self, header: str, headers: frozenset[str], may_be_made: bool) -> str:
        """Return the header that is intended, in the same folder or of the same name in another one.

        Where others may be made, only one that is a letter or two off.
        """
        folder, _, name = header.rpartition("/")
        names = [each.rpartition("/")[2] for each in headers if each.rpartition("/")[0] == folder]
        close = near_names(name, with_digits_of(name, names), 1 if len(name) < SHORT else 2)
        if close or may_be_made:
            return f"{folder}/{close[0]}" if close else ""
        moved = [each for each in headers if each.rpartition("/")[2] == name]
        stems = {each.rpartition(".")[0]: each for each in names}
        stem = name.rpartition(".")[0]
        alike = stem if stem in stems else nearest(stem, stems)
        return moved[0] if len(moved) == 1 else f"{folder}/{stems[alike]}" if alike else ""

    def may_mean(self, source: CppFile, header: str, meant: str) -> bool:
        """Return whether a file may have meant an own header: its name is a slip away, or it holds what is used."""
        written, name = posixpath.basename(header), posixpath.basename(meant)
        same = written.partition(".")[0] == name.partition(".")[0]
        if not meant or same or near_names(written, [name], 1 if len(written) < SHORT else 2):
            return True
        paths = [path for path in self.by_name.get(name, ()) if f"/{path}".endswith(f"/{meant}")]
        files = [file for file in self.sources if file.path in paths]
        return len(files) != 1 or may_be_for(source, files[0])

    def beside(self, source: CppFile, name: str) -> str | None:
        """Return the header in the folder of a file that is one or two letters off."""
        folder = posixpath.dirname(source.path)
        paths = self.package.cmake.package_files.paths
        beside = (path for path in paths if posixpath.dirname(path) == folder and path.endswith(HEADERS))
        headers = (path for path in beside if path != source.path)
        alike = with_digits_of(name, map(posixpath.basename, headers))
        return next(iter(near_names(name, alike, 1 if len(name) < SHORT else 2)), None)

    def others(self, source: CppFile, headers: frozenset[str]) -> frozenset[str]:
        """Return the headers without the one that includes: a file is never meant by an include in itself."""
        return frozenset(each for each in headers if not f"/{source.path}".endswith(f"/{each}"))

    @cached_property
    def by_name(self) -> dict[str, list[str]]:
        found: dict[str, list[str]] = {}
        for path in self.package.cmake.package_files.paths:
            found.setdefault(posixpath.basename(path), []).append(path)
        return found

    @cached_property
    def own(self) -> frozenset[str]:
        """The headers of the package in a folder of its name, as they are included."""
        name = self.package.facts.name
        inside = (f"/{path}".rpartition(f"/{name}/") for path in self.package.cmake.package_files.paths)
        return frozenset(f"{name}/{rest}" for _, found, rest in inside if found and rest.endswith(HEADERS))

    @cached_property
    def ros1(self) -> Ros1Sources:
        package = self.package
        headers = Ros1Headers(package.facts, package.cmake.package_files, self.workspace)
        return Ros1Sources(headers, package.cmake, self.sources)

    @cached_property
    def is_of_library(self) -> bool:
        """Whether CMake looks outside for what is called like the package: its headers may be in the same folder."""
        name, calls = self.package.facts.name.lower(), self.package.cmake.named(*LOOKING)
        texts = {text for call in calls for text in call.texts if not OF_INTERFACES.fullmatch(text)}
        outside = (text for text in texts if text == self.package.facts.name or self.workspace.named(text) is None)
        alike = (text.lower().removeprefix("lib") for text in outside)
        return any(text == name or text.startswith(tuple(f"{name}{sign}" for sign in "-_./:")) for text in alike)

    @cached_property
    def may_make(self) -> bool:
        return may_make_headers(self.package.cmake)

    def harm_in(self, path: str) -> Level:
        package = self.package
        if is_unmet(package.cmake, self.sources, path, self.workspace, package.facts.name):
            return "info"
        return harm_in(package.cmake, self.sources, path)

    @cached_property
    def guarded(self) -> frozenset[str]:
        """The files that others include under a condition alone: the compiler may never see them."""
        return only_under_conditions(self.package.cmake, self.sources)

    @cached_property
    def compiled(self) -> set[str]:
        return own_compiled(self.package.cmake, self.sources) or set()


def with_digits_of(name: str, names: Iterable[str]) -> list[str]:
    """Return the names with the same digits: `v1.hpp` and `v2.hpp` are no misspellings of each other."""
    wanted = list(filter(str.isdecimal, name))
    return [each for each in names if list(filter(str.isdecimal, each)) == wanted]


def is_for_ros1(source: CppFile) -> bool:
    """Return whether a file includes ROS 1 itself: one for both versions leaves the choice to the preprocessor."""
    return any(each.path == "ros/ros.h" and not each.is_conditional for each in source.includes)

"""Headers that C++ includes from a folder of no package: a misspelt one, or one of ROS 1 (CMK201)."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cached_property
from itertools import islice
from typing import Literal

from ...languages.cpp.file import CppFile, IncludeDirective
from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...package.cmake.made_headers import HEADERS
from ...ros.headers import LIBRARIES, SHARED
from ...ros.interfaces import KINDS, header_name
from ...ros.names import NameKind
from ...source import Span
from ...suggest import near_names
from ..cmake.mistyped_links import digits
from ..depends.compiled_sources import compiled_sources
from ..depends.ros1_sources import Ros1Use
from ..fault import Level
from ..interfaces.known_interfaces import KnownInterfaces
from .missing_headers import MissingHeaders

FOLDER = regex(r"[a-z][a-z0-9_]{4,}")
SHORT = 8
"""Letters of a folder's name from which two may be wrong."""
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
        if not package.is_ament or (self.is_for_both and not ROS_1.isdisjoint(self.declared)):
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
        near = self.headers.ros1.headers.with_kind(each.path) or self.in_right_folder(each.path)
        if near:
            is_other = digits(folder_of(near)) != digits(folder_of(each.path))
            level = "warning" if is_other and level == "error" else level
            behind = self.headers.ros1.stopping_all([source.path])
            yield ForeignHeader(source.path, each.span, each.path, "folder", near, level, behind)

    def in_right_folder(self, header: str) -> str | None:
        """Return the header in the folder of the one package that is near and has it; None where there is none."""
        folder, _, rest = header.partition("/")
        if not FOLDER.fullmatch(folder) or folder in self.folders:
            return None
        if self.headers.workspace.kind_of(folder) in (NameKind.PACKAGE, NameKind.KEY):
            return None
        alike = (each for each in self.packages if digits(each) == digits(folder))
        near = near_names(folder, alike, 1 if len(folder) < SHORT else 2)
        found = [f"{each}/{rest}" for each in near if self.has(each, rest)] or self.with_other_digits(folder, rest)
        return found[0] if len(found) == 1 and not self.is_of_others(folder) else None

    def with_other_digits(self, folder: str, rest: str) -> list[str]:
        """Return the headers, with any ending, of packages of the workspace whose name has a digit more or less."""
        stem, name = rest.rpartition(".")[0], folder.rstrip("0123456789_")
        near = [facts for facts in self.headers.workspace.packages if facts.name.rstrip("0123456789_") == name]
        wanted = {f"{facts.name}/{stem}{ending}" for facts in near for ending in HEADERS}
        return sorted({each for facts in near for each in facts.header_files if each in wanted}) if stem else []

    def is_of_others(self, folder: str) -> bool:
        """Return whether another package of the workspace has headers in a folder."""
        headers = (each for facts in self.headers.workspace.packages for each in facts.header_files)
        return any(each.startswith(f"{folder}/") for each in headers)

    def has(self, package: str, rest: str) -> bool:
        """Return whether a package certainly has a header in the folder of its name."""
        kind, _, name = rest.partition("/")
        if kind in KINDS and (known := self.interfaces.of(package)) is not None:
            return name.partition(".")[0] in map(header_name, known.get(kind, ()))
        return self.headers.known.is_there(f"{package}/{rest}") or package in self.used

    @cached_property
    def packages(self) -> frozenset[str]:
        """The packages whose headers the package may include."""
        return frozenset({*self.headers.workspace.names, *self.declared, self.headers.package.facts.name})

    @cached_property
    def declared(self) -> frozenset[str]:
        return frozenset(each.name for each in self.headers.package.manifest.dependencies)

    @cached_property
    def used(self) -> frozenset[str]:
        """The folders from which more than one header is included: those of packages that are declared and not here."""
        outside = self.declared.difference(self.headers.workspace.names)
        named = [each.path.partition("/")[0] for source in self.headers.sources for each in source.includes]
        return frozenset(name for name in outside if named.count(name) > 1)

    @cached_property
    def folders(self) -> frozenset[str]:
        """The folders of the package and of libraries, and the packages that are here or declared."""
        own = (part for path in self.headers.package.cmake.package_files.paths for part in path.split("/")[:-1])
        return frozenset({*own, *LIBRARIES, *SHARED, *self.packages})

    @cached_property
    def interfaces(self) -> KnownInterfaces:
        return KnownInterfaces(self.headers.package.facts, self.headers.workspace)


def folder_of(header: str) -> str:
    return header.partition("/")[0]

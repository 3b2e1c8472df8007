"""Headers of the package that exist, in a folder that is no include directory of the target (CMK201)."""

from __future__ import annotations

import posixpath
from collections.abc import Iterator
from functools import cached_property
from itertools import islice

from ...languages.cpp.file import CppFile
from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...package.cmake.foreign_commands import foreign_commands
from ...source import Span
from ..cmake.source_targets import SourceTargets
from ..depends.compiled_sources import harm_in
from ..depends.ros1_sources import Ros1Use
from .include_folders import IncludeFolders
from .missing_headers import MissingHeaders

OTHERWISE = regex(
    r"\b(?:INTERFACE_(?:SYSTEM_)?|CMAKE_\w+_STANDARD_)?INCLUDE_DIRECTORIES\b|INCLUDE_CURRENT_DIR|FILE_SET|ament_auto_"
    r"|(?<!\w)-I|isystem|(?i:(?<![a-z_])link_libraries\s*\()"
)
"""What in a CMake file adds an include directory in another way, or may do so."""


@dataclass(frozen=True, slots=True)
class UnreachedHeader:
    path: str
    span: Span
    header: str
    folder: str
    """Where it lies, below the package."""
    target: str = ""
    """The target without the include directory; "" where no command adds one."""
    behind: Ros1Use | None = None
    """What of ROS 1 ends the build of all targets with the file."""
    is_off: bool = False
    """Whether the file is compiled only with a switch that nothing turns on, or in a target that nothing needs."""


@dataclass(frozen=True)
class UnreachedHeaders:
    headers: MissingHeaders

    def first(self) -> Iterator[UnreachedHeader]:
        """Yield the first include that the compiler does not find, if possible in a file surely compiled."""
        yield from sorted(self.all(), key=lambda each: each.is_off or each.behind is not None)[:1]

    def all(self) -> Iterator[UnreachedHeader]:
        """Yield the first of each file."""
        cmake = self.headers.package.cmake
        is_known = cmake.is_complete and not cmake.reads_unknown_files and next(foreign_commands(cmake), None) is None
        finds_itself = any(found.name == self.headers.package.facts.name for found in cmake.packages)
        if not is_known or finds_itself or any(OTHERWISE.search(file.source.text) for file in cmake.files):
            return
        for source in self.headers.sources:
            if source.path in self.headers.compiled - self.headers.guarded:
                yield from islice(self.within(source), 1)

    def within(self, source: CppFile) -> Iterator[UnreachedHeader]:
        workspace, name = self.headers.workspace, self.headers.package.facts.name
        for each in source.includes:
            neighbour = posixpath.normpath(posixpath.join(posixpath.dirname(source.path), each.path))
            paths = self.headers.known.by_name.get(posixpath.basename(each.path), ())
            if each.is_conditional or "/" not in each.path or (neighbour in paths and not each.is_angled):
                continue
            owners = {facts.name for facts in workspace.having("header_files", each.path)} - {name}
            folders = [path.removesuffix(f"/{each.path}") for path in paths if path.endswith(f"/{each.path}")]
            is_clear = len(folders) == 1 and not owners and posixpath.basename(folders[0]) == "include"
            if is_clear and (target := self.without(source.path, folders[0])) is not None:
                behind = self.headers.ros1.stopping_all([source.path])
                is_off = harm_in(self.headers.package.cmake, self.headers.sources, source.path) == "info"
                yield UnreachedHeader(source.path, each.span, each.path, folders[0], target, behind, is_off)

    def without(self, source: str, folder: str) -> str | None:
        """Return a target that compiles a source without a folder; "" where none has any, None where all may."""
        if not self.folders.are_named:
            return ""
        cmake = self.headers.package.cmake
        names = sorted(self.targets.targets_of(source))
        found = [target for target in cmake.targets if target.name in names]
        is_open = any(target.call.maybe or target.call.testing or not target.is_built for target in found)
        if not found or is_open or any(self.folders.may_reach(name, folder) for name in names):
            return None
        return names[0]

    @cached_property
    def folders(self) -> IncludeFolders:
        return IncludeFolders(self.headers.package)

    @cached_property
    def targets(self) -> SourceTargets:
        return SourceTargets(self.headers.package.cmake)

"""Headers of the package that are there, in a folder of which no command tells the compiler (CMK201)."""

from __future__ import annotations

import posixpath
from collections.abc import Iterator

from ...languages.cpp.file import CppFile
from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...package.cmake.foreign_commands import foreign_commands
from ...source import Span
from .missing_headers import MissingHeaders

TELLS = regex(
    r"(?i:(?<![a-z_])(?:target_)?include_directories\s*\()|\bINCLUDE_DIRECTORIES\b|INCLUDE_CURRENT_DIR|FILE_SET"
    r"|ament_auto_|(?<!\w)-I|isystem"
)
"""What a CMake file holds that tells the compiler of a folder, or may do so."""


@dataclass(frozen=True, slots=True)
class UnreachedHeader:
    path: str
    span: Span
    header: str
    folder: str
    """Where it lies, below the package."""


@dataclass(frozen=True)
class UnreachedHeaders:
    headers: MissingHeaders

    def first(self) -> Iterator[UnreachedHeader]:
        """Yield the first include of a header that no compiler finds, where nothing tells of any folder: one cause."""
        cmake = self.headers.package.cmake
        is_known = cmake.is_complete and not cmake.reads_unknown_files and next(foreign_commands(cmake), None) is None
        finds_itself = any(found.name == self.headers.package.facts.name for found in cmake.packages)
        if not is_known or finds_itself or any(TELLS.search(file.source.text) for file in cmake.files):
            return
        for source in self.headers.sources:
            if source.path in self.headers.compiled:
                found = next(self.within(source), None)
                if found is not None:
                    yield found
                    return

    def within(self, source: CppFile) -> Iterator[UnreachedHeader]:
        workspace, name = self.headers.workspace, self.headers.package.facts.name
        for each in source.includes:
            beside = posixpath.normpath(posixpath.join(posixpath.dirname(source.path), each.path))
            paths = self.headers.by_name.get(posixpath.basename(each.path), ())
            if each.is_conditional or "/" not in each.path or (beside in paths and not each.is_angled):
                continue
            owners = {facts.name for facts in workspace.having("header_files", each.path)} - {name}
            folders = [path.removesuffix(f"/{each.path}") for path in paths if path.endswith(f"/{each.path}")]
            if len(folders) == 1 and not owners and posixpath.basename(folders[0]) == "include":
                yield UnreachedHeader(source.path, each.span, each.path, folders[0])

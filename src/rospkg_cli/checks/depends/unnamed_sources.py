"""Sources that no CMake file names, while their neighbours are named one by one: they are not compiled."""

from __future__ import annotations

import posixpath
import re
from functools import cached_property

from ...files import PackageFiles
from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from .header_inclusions import HEADERS

TAKES_ALL = regex(r"\bGLOB(?:_RECURSE)?\b|\baux_source_directory\b", re.IGNORECASE)
MAKES_NAMES = regex(r"\}(?:_\w+)?\.c(?:pp|c|xx|\b)")
"""The names of sources are made of others, `${name}.cpp`: those of the folder of the file, or below it."""
MODULES = (".cmake", ".cmake.in")
ENOUGH = 2
"""So many neighbours are named."""


@dataclass(frozen=True)
class UnnamedSources:
    files: PackageFiles

    def has(self, path: str) -> bool:
        """Return whether a source is left out; of a header, and where CMake may take all, that is not known."""
        if path.endswith(HEADERS) or self.takes_all or posixpath.basename(path) in self.text or self.may_be_made(path):
            return False
        suffix = posixpath.splitext(path)[1]
        neighbours = self.by_folder[posixpath.dirname(path)]
        return sum(each.endswith(suffix) and each in self.text for each in neighbours) >= ENOUGH

    def may_be_made(self, path: str) -> bool:
        """Return whether a file of a folder around a source makes names of sources."""
        around = (each for each in self.lists if path.startswith(each.removesuffix("CMakeLists.txt")))
        return any(MAKES_NAMES.search(self.files.readable_text(each)) for each in around)

    @cached_property
    def by_folder(self) -> dict[str, list[str]]:
        found: dict[str, list[str]] = {}
        for path in self.files.paths:
            found.setdefault(posixpath.dirname(path), []).append(path)
        return found

    @cached_property
    def takes_all(self) -> bool:
        return any(TAKES_ALL.search(self.files.readable_text(path)) for path in self.lists)

    @cached_property
    def lists(self) -> tuple[str, ...]:
        return tuple(path for path in self.files.paths if posixpath.basename(path) == "CMakeLists.txt")

    @cached_property
    def text(self) -> str:
        """All CMake files together."""
        paths = (path for path in self.files.paths if path in self.lists or path.endswith(MODULES))
        return "\n".join(self.files.readable_text(path) for path in paths)

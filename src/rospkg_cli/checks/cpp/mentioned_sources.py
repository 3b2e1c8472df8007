"""Whether a CMake file or a source of a package names a C++ file, so that it may be compiled."""

from __future__ import annotations

import posixpath
import re
from functools import cached_property

from ...languages.cpp.file import CppFile
from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...package.cmake.cmake_project import CMake

MADE_OF_NAMES = regex(r"\}(?:_\w+)?\.c|\bGLOB(?:_RECURSE)?\b")
"""What makes names of sources from those of targets, `${name}.cpp`, or takes all files that are there."""


@dataclass(frozen=True)
class MentionedSources:
    cmake: CMake
    sources: tuple[CppFile, ...]

    def has(self, path: str) -> bool:
        """Return whether a CMake file has the name, in a comment too, or a file of the package includes it.

        The name without its ending counts as well, but not that of an XML or YAML file; where it is that of a target
        and no file makes sources of names, among sources alone.
        """
        name = posixpath.basename(path)
        stem, texts = posixpath.splitext(name)[0], [file.source.text for file in self.cmake.files]
        target, has_file = self.cmake.target(stem), self.cmake.package_files.has_file
        is_whole = target is not None and all(has_file(word.text) for word in target.sources)  # CMK102 reports others
        is_target = is_whole and not any(MADE_OF_NAMES.search(each) for each in texts)
        word = re.compile(rf"(?<![\w.-]){re.escape(name if is_target else stem)}(?!\.(?:xml|ya?ml)\b)(?![\w-])")
        is_source = stem in self.source_names or name in self.included
        return is_source or any(word.search(text) for text in texts)

    @cached_property
    def source_names(self) -> frozenset[str]:
        """The last parts of the sources of all targets, as they are written."""
        words = (word for target in self.cmake.targets for word in target.sources)
        return frozenset(posixpath.basename(word.text) for word in words)

    @cached_property
    def included(self) -> frozenset[str]:
        return frozenset(posixpath.basename(each.path) for source in self.sources for each in source.includes)

"""Install rules that stand in comments: what they name was left out on purpose."""

from __future__ import annotations

import re
from collections.abc import Iterator
from functools import cached_property
from itertools import takewhile

from ...languages.cmake.file import CMakeFile
from ...languages.cmake.targets import Target
from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...package.cmake.cmake_project import CMake

SIGN = regex(r"^#+(?:\[=*\[)?|\]=*\]$")
INSTALLS = regex(r"\binstall\s*\(\s*TARGETS\b([^()]*)", re.IGNORECASE)
FOLDERS = regex(r"\binstall\s*\(\s*DIRECTORY\b([^()]*)", re.IGNORECASE)
HERE = "${CMAKE_CURRENT_SOURCE_DIR}/"
WORD = regex(r"[^\s\"]+")
KEYWORDS = frozenset({
    "EXPORT", "ARCHIVE", "LIBRARY", "RUNTIME", "OBJECTS", "DESTINATION", "PERMISSIONS", "CONFIGURATIONS", "COMPONENT",
    "OPTIONAL", "INCLUDES", "TYPE", "FILES_MATCHING", "PATTERN", "REGEX", "USE_SOURCE_PERMISSIONS",
})  # fmt: skip
"""What ends the names of the targets or folders."""


@dataclass(frozen=True)
class CommentedInstalls:
    cmake: CMake

    def has(self, target: Target) -> bool:
        """Return whether a comment installs a target, by its name or as it is written where it is made."""
        written = self.cmake.source_text(target.word).strip('"')
        return not self.names.isdisjoint((target.name, written))

    def has_folder(self, folder: str) -> bool:
        """Return whether a comment installs a folder, as one of the package."""
        return any(word.rstrip("/").removeprefix(HERE).removeprefix("./") == folder for word in self.folders)

    @cached_property
    def folders(self) -> frozenset[str]:
        return frozenset(self.words_of(FOLDERS))

    @cached_property
    def names(self) -> frozenset[str]:
        return frozenset(self.words_of(INSTALLS))

    def words_of(self, rules: re.Pattern[str]) -> Iterator[str]:
        """Yield what rules in comments install, as it is written."""
        for file in self.cmake.files:
            for words in map(WORD.findall, rules.findall(said_in(file))):
                yield from takewhile(lambda word: word not in KEYWORDS, words)


def said_in(file: CMakeFile) -> str:
    """Return what the comments of a CMake file say, without their signs: a rule that is laid aside has one a line."""
    return "\n".join(SIGN.sub("", file.source.slice(span)).lstrip(" \t#") for span in file.syntax.comments)

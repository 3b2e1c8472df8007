"""Install rules that stand in comments: what they name was left out on purpose."""

from __future__ import annotations

import re
from functools import cached_property

from ...languages.cmake.targets import Target
from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...package.cmake.cmake_project import CMake

SIGN = regex(r"^#+(?:\[=*\[)?|\]=*\]$")
INSTALLS = regex(r"\binstall\s*\(\s*TARGETS\b([^()]*)", re.IGNORECASE)
WORD = regex(r"[^\s\"]+")
KEYWORDS = frozenset({
    "EXPORT", "ARCHIVE", "LIBRARY", "RUNTIME", "OBJECTS", "DESTINATION", "PERMISSIONS", "CONFIGURATIONS", "COMPONENT",
    "OPTIONAL", "INCLUDES",
})  # fmt: skip
"""What ends the names of the targets."""


@dataclass(frozen=True)
class CommentedInstalls:
    cmake: CMake

    def has(self, target: Target) -> bool:
        """Return whether a comment installs a target, by its name or as it is written where it is made."""
        written = self.cmake.source_text(target.word).strip('"')
        return not self.names.isdisjoint((target.name, written))

    @cached_property
    def names(self) -> frozenset[str]:
        """What is installed in comments, as it is written; the lines of one comment each have a sign."""
        found: set[str] = set()
        for file in self.cmake.files:
            lines = (SIGN.sub("", file.source.slice(span)) for span in file.syntax.comments)
            for words in map(WORD.findall, INSTALLS.findall("\n".join(lines))):
                end = next((at for at, word in enumerate(words) if word in KEYWORDS), len(words))
                found.update(words[:end])
        return frozenset(found)

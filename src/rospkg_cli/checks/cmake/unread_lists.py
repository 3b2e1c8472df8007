"""Lists that are appended to and never read, and that are nearly called like one that is."""

from __future__ import annotations

import re
from collections.abc import Iterator
from functools import cached_property

from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...package.cmake.cmake_project import CMake
from ...source import Span
from ...suggest import near_names
from .name_slips import digits

NAME = regex(r"[A-Za-z_]\w{7,}")
"""A name that is long enough to differ from others on purpose."""
READ = regex(r"\$\{([A-Za-z_]\w{7,})\}")
GROWS = frozenset({"APPEND", "PREPEND"})


@dataclass(frozen=True, slots=True)
class UnreadList:
    path: str
    span: Span
    name: str
    near: str


@dataclass(frozen=True)
class UnreadLists:
    cmake: CMake

    def all(self) -> Iterator[UnreadList]:
        """Yield the first place of each; nothing where a file that can't be read may read any variable."""
        if self.cmake.reads_unknown_files:
            return
        places: dict[str, list[UnreadList]] = {}
        for file in self.cmake.files:
            for command in file.syntax.commands:
                if command.name != "list" or len(command.arguments) < 3 or command.arguments[0].text not in GROWS:
                    continue
                name, span = command.arguments[1].text, command.arguments[1].span
                if NAME.fullmatch(name):
                    places.setdefault(name, []).append(UnreadList(file.path, span, name, ""))
        for name, found in places.items():
            if self.mentions(name) == len(found) and (near := self.nearest(name)):
                yield UnreadList(found[0].path, found[0].span, name, near)

    def mentions(self, name: str) -> int:
        """Return how often a name stands in the CMake files, also in comments."""
        word = re.compile(rf"(?<!\w){name}(?!\w)")
        return sum(len(word.findall(file.source.text)) for file in self.cmake.files)

    def nearest(self, name: str) -> str | None:
        alike = (each for each in self.read if digits(each) == digits(name))
        near = near_names(name, alike)
        return near[0] if len(near) == 1 else None

    @cached_property
    def read(self) -> frozenset[str]:
        """The variables that are read somewhere."""
        return frozenset(name for file in self.cmake.files for name in READ.findall(file.source.text))

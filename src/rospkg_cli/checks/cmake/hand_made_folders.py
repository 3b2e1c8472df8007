"""Folders that CMake installs, that are not in git, and that a page or a script says to create (CMK102)."""

from __future__ import annotations

import posixpath
import re
from functools import cached_property

from ...files import PackageFiles
from ...light_dataclasses import dataclass
from ..repository.left_to_people import is_of_people
from ..repository.pages_and_scripts import own_pages, pages_above, texts_above

MAKES = r"(?im)^.*\bmkdir\b[^\n]*[ \t\"'{1}]{0}(?![\w.-])"
BRINGS = (
    r"(?im)^.*\b(?:cp|mv|ln|unzip|tar|wget|curl|gdown|rsync|scp|git[ \t]+clone)\b[^\n]*"
    r"[ \t\"'{1}]{0}(?:/[^\s\"'`]*)?[\"'`]?[ \t]*$"
)
"""What is brought to a folder has it as the last word."""
SAYS = (
    r"(?im)^.*\b(?:create|make|put|place|copy|store|save|add|extract|unpack|download\w*)\b[^\n]*"
    r"(?:[`\"'*]{0}/?[`\"'*]|[ \t]{0}/?[ \t](?:folder|directory)\b)"
)
"""What a page says in words."""
START = r"(?:(?:\.{1,2}|\$\{?\w+\}?|\$\([^)\n]*\))/)*"
"""What may stand before a folder of the package: `../`, `$HERE/`."""
SHOWS_CREATION = "ros2 pkg create"
"""A page with it says how the package was created, and not what to do with it."""
RUN = (".sh", ".bash", ".yml", ".yaml", ".json", "Makefile", "Dockerfile", "justfile")
"""Files that make folders themselves."""


@dataclass(frozen=True)
class HandMadeFolders:
    files: PackageFiles
    names: frozenset[str]
    """Names by which pages outside may call the folder of the package."""

    def is_left(self, path: str) -> bool:
        """Return whether a script makes or fills a folder, or a page says to do so with one that users fill."""
        if self.is_in(self.scripts, path, (MAKES, BRINGS)):
            return True
        return is_of_people(path) and self.is_in(self.pages, path, (MAKES, BRINGS, SAYS))

    def is_in(self, texts: tuple[tuple[str, ...], tuple[str, ...]], path: str, patterns: tuple[str, ...]) -> bool:
        """Return whether a text names a folder, from that of the package or from above it."""
        own, above = texts
        whole = re.escape(posixpath.normpath(path))
        named = [f"{re.escape(name)}/{whole}" for name in sorted(self.names)]
        return has_line(own, f"{START}{whole}", "", patterns) or any(
            has_line((*own, *above), each, "/", patterns) for each in named
        )

    @cached_property
    def pages(self) -> tuple[tuple[str, ...], tuple[str, ...]]:
        """The pages of the package, or of a repository that is one, and those above it."""
        own, above = own_pages(self.files), pages_above(self.files)
        return (own, above) if self.files.folder else ((*own, *above), ())

    @cached_property
    def scripts(self) -> tuple[tuple[str, ...], tuple[str, ...]]:
        """The scripts of the package, or of a repository that is one, and those above it."""
        own = tuple(self.files.readable_text(each) for each in self.files.paths if each.endswith(RUN))
        above = texts_above(self.files, RUN)
        return (own, above) if self.files.folder else ((*own, *above), ())


def has_line(texts: tuple[str, ...], folder: str, before: str, given: tuple[str, ...]) -> bool:
    patterns = [re.compile(each.replace("{0}", folder).replace("{1}", before)) for each in given]
    return any(each.search(text) for text in texts if SHOWS_CREATION not in text for each in patterns)

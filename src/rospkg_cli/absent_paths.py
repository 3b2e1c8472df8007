"""Paths that a working tree lacks on purpose: git ignores them, or they lie in a submodule that is not checked out."""

from __future__ import annotations

import re
from functools import cached_property

from .gitignore import IgnorePattern, folders_above, is_ignored, read_patterns
from .lazy_regex import regex
from .light_dataclasses import dataclass, field
from .tree import Tree

SUBMODULE = regex(r"^[ \t]*path[ \t]*=[ \t]*(\S+)", re.MULTILINE)
SUBMODULE_NAME = regex(r"^[ \t]*(?:path|url)[ \t]*=[ \t]*(?:\S*?[/:])?([^\s/:]+(?:/[^\s/:]+)?)/?[ \t]*$", re.MULTILINE)
MAX_SUBMODULES = 10_000


@dataclass(frozen=True)
class AbsentPaths:
    """What a build or `git submodule update --init` adds to a package; paths are relative to the package."""

    tree: Tree = field(repr=False)
    """The package's own."""
    whole: Tree = field(repr=False)
    """That of the run, whose files above the package count too."""
    folder: str = ""
    """The package's, in the tree of the run."""

    def is_expected(self, path: str) -> bool:
        """Return whether a path that is not there is no fault: a build writes it, or a submodule holds it."""
        return self.is_ignored(path) or self.submodule_of(path) is not None

    def is_ignored(self, path: str) -> bool:
        """Return whether a .gitignore of the package, or above it, names a path."""
        place = self.place_of(path)
        patterns = {folder: self.patterns_in(folder) for folder in folders_above(place)}
        return is_ignored(place, patterns)

    def submodule_of(self, path: str) -> str | None:
        """Return the submodule, relative to the package, that holds a path and is not checked out."""
        return next((each for each in self.empty_submodules if f"{path}/".startswith(f"{each}/")), None)

    def place_of(self, path: str) -> str:
        return f"{self.folder}/{path}" if self.folder else path

    def patterns_in(self, folder: str) -> tuple[IgnorePattern, ...]:
        if folder not in self._patterns:
            self._patterns[folder] = read_patterns(self.text(f"{folder}/.gitignore".removeprefix("/")))
        return self._patterns[folder]

    @cached_property
    def _patterns(self) -> dict[str, tuple[IgnorePattern, ...]]:
        return {}

    @cached_property
    def empty_submodules(self) -> tuple[str, ...]:
        inside = f"{self.folder}/" if self.folder else ""
        places = (
            f"{folder}/{path}".removeprefix("/").rstrip("/")
            for folder, text in self.submodule_lists.items()
            for path in SUBMODULE.findall(text)[:MAX_SUBMODULES]
        )
        own = [place.removeprefix(inside) for place in places if place.startswith(inside)]
        return tuple(each for each in own if not self.has_files(each))

    @cached_property
    def submodule_names(self) -> tuple[str, ...]:
        """The last two parts of the path and of the address of every submodule around, checked out or not."""
        texts = self.submodule_lists.values()
        return tuple(name for text in texts for name in SUBMODULE_NAME.findall(text)[: 2 * MAX_SUBMODULES])

    @cached_property
    def submodule_lists(self) -> dict[str, str]:
        """The text of .gitmodules, "" where there is none, by folder: that of the package, and those above it."""
        folders = folders_above(f"{self.folder}/package.xml".removeprefix("/"))
        return {folder: self.text(f"{folder}/.gitmodules".removeprefix("/")) for folder in folders}

    def has_files(self, folder: str) -> bool:
        return any(path.startswith(f"{folder}/") for path in self.tree.files())

    def text(self, path: str) -> str:
        """Return the text of a file of the run; "" where there is none."""
        try:
            return self.whole.entry(path).text.text
        except (OSError, UnicodeError):
            return ""

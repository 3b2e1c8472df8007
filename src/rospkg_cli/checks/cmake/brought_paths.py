"""Missing paths that a page or a list of repositories says to create or fetch before the build (CMK102)."""

from __future__ import annotations

import posixpath
import re
from collections.abc import Iterator
from functools import cached_property

from ...files import PackageFiles
from ...light_dataclasses import dataclass
from ...package.cmake.referenced_paths import Use
from ..repository.left_to_people import UNTIL_MADE
from ..repository.pages_and_scripts import FetchedFiles, pages_and_scripts
from ..repository.script_outputs import ScriptOutputs
from .hand_made_folders import HandMadeFolders

LISTS = (".repos", ".rosinstall")
CLONES = r"(?im)\bgit[ \t]+(?:clone|submodule[ \t]+add)\b[^\n]*[/ \t]{0}(?:\.git)?/?(?![\w.-])"
LISTED = r"(?m)^[ \t\"'-]*(?:local-name:[ \t]*)?(?:[\w.-]+/)*{0}[\"']?:?[ \t]*$"
"""How pages and lists name the folder of a repository that is to be fetched."""
OF_CODE = frozenset("src include lib launch config".split())
"""Folders of every package, which `git clone … src` does not bring."""


@dataclass(frozen=True)
class BroughtPaths:
    files: PackageFiles
    names: frozenset[str]
    """How pages outside may call the folder of the package."""

    def why_left(self, use: Use, paths: list[str]) -> str:
        """Return why some paths of one use exist for all who follow a page; "" where they may be missing."""
        return UNTIL_MADE if paths and all(self.is_brought(use, each) for each in paths) else ""

    def is_brought(self, use: Use, path: str) -> bool:
        """Return whether one is: a folder is made or filled, a file written or copied, or a repository cloned."""
        if ScriptOutputs(self.files, self.names).has(path, is_folder=use in ("folder", "matching", "subdirectory")):
            return True
        if use in ("folder", "matching"):
            return HandMadeFolders(self.files, self.names).is_left(path)
        return self.is_cloned(path) or (use == "install" and FetchedFiles(self.files).has_itself(path))

    def is_cloned(self, path: str) -> bool:
        """Return whether a folder around a path, of which nothing is there, is called like what is to be cloned."""
        folders = [each for each in folders_around(path) if not self.files.below(each)]
        names = [re.escape(name) for each in folders if (name := posixpath.basename(each)) not in OF_CODE]
        return any(
            re.search(pattern.replace("{0}", name), text)
            for name in names
            for pattern, texts in ((CLONES, self.pages), (LISTED, self.lists))
            for text in texts
        )

    @cached_property
    def pages(self) -> tuple[str, ...]:
        return pages_and_scripts(self.files)

    @cached_property
    def lists(self) -> tuple[str, ...]:
        """What the lists of repositories say, in the package and in the folders above it."""
        own = [self.files.readable_text(path) for path in self.files.paths if path.endswith(LISTS)]
        whole = PackageFiles(self.files.whole) if self.files.whole is not None else None
        around = [path for path in whole.every if path.endswith(LISTS) and self.is_above(path)] if whole else []
        return (*own, *(whole.readable_text(path) for path in around if whole))

    def is_above(self, path: str) -> bool:
        folder = posixpath.dirname(path)
        return not folder or f"{self.files.folder}/".startswith(f"{folder}/")


def folders_around(path: str) -> Iterator[str]:
    while path := posixpath.dirname(path):
        yield path

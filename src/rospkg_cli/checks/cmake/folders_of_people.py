"""Folders that CMake installs, that git does not hold, and that a page or a script has people make (CMK102)."""

from __future__ import annotations

import posixpath
import re

from ...files import PackageFiles
from ...light_dataclasses import dataclass
from ..left_to_people import UNTIL_MADE, is_of_people
from ..pages_and_scripts import own_pages, pages_above

MAKES = r"(?im)^.*\bmkdir\b[^\n]*[ \t\"'{1}]{0}(?![\w.-])"
BRINGS = (
    r"(?im)^.*\b(?:cp|mv|ln|unzip|tar|wget|curl|gdown|rsync|scp|git[ \t]+clone)\b[^\n]*"
    r"[ \t\"'{1}]{0}(?:/[^\s\"'`]*)?[\"'`]?[ \t]*$"
)
"""What is brought to a folder has it as the last word."""
TELLS_OF_CREATING = "ros2 pkg create"
"""A page with it tells how the package came to be, and not what to do with it."""


@dataclass(frozen=True)
class FoldersOfPeople:
    files: PackageFiles
    names: frozenset[str]
    """How pages outside may call the folder of the package."""

    def why_left(self, paths: list[str]) -> str:
        """Return why nobody who does as a page says misses some folders; "" where somebody may."""
        return UNTIL_MADE if paths and all(is_of_people(each) and self.is_made(each) for each in paths) else ""

    def is_made(self, path: str) -> bool:
        """Return whether a page or script makes or fills a folder, named from that of the package or from above it."""
        whole = re.escape(posixpath.normpath(path))
        above = [f"{re.escape(name)}/{whole}" for name in sorted(self.names)]
        own = has_line(own_pages(self.files), rf"(?:\./)?{whole}", "")
        texts = (*own_pages(self.files), *pages_above(self.files))
        return own or any(has_line(texts, each, "/") for each in above)


def has_line(texts: tuple[str, ...], folder: str, before: str) -> bool:
    patterns = [re.compile(each.replace("{0}", folder).replace("{1}", before)) for each in (MAKES, BRINGS)]
    return any(each.search(text) for text in texts if TELLS_OF_CREATING not in text for each in patterns)

"""Rule input: files that a page or a script of the package has fetched, unpacked or made, beside what git holds."""

from __future__ import annotations

import posixpath
from functools import cached_property

from ..files import PackageFiles
from ..lazy_regex import regex
from ..light_dataclasses import dataclass
from .pages_and_scripts import pages_and_scripts

FETCHES = regex(
    r"(?im)^.*\b(?:unzip|unrar|7z|tar|wget|curl|gdown|rsync|scp|download\w*|git[ \t]+(?:lfs|clone|submodule))\b.*$"
)
"""A line that tells to bring or to unpack files."""
ARCHIVES = (".zip", ".tar", ".tar.gz", ".tgz", ".tar.xz", ".7z", ".rar")


@dataclass(frozen=True)
class FetchedFiles:
    files: PackageFiles

    def has(self, path: str) -> bool:
        """Return whether a line that brings files names a missing one: it, its folder, or an archive called so."""
        folder, name = posixpath.split(path)
        stem = name.partition(".")[0]
        packed = [f"{each}{suffix}" for each in {stem, posixpath.basename(folder)} if each for suffix in ARCHIVES]
        wanted = (name, *([f"{folder}/"] if folder else []), *packed)
        return any(each in line for line in self.lines for each in wanted)

    @cached_property
    def lines(self) -> tuple[str, ...]:
        return tuple(each.group() for text in pages_and_scripts(self.files) for each in FETCHES.finditer(text))

"""Which files of a folder are lists of repositories for vcs or wstool: by their ending, or by what they hold."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from pathlib import Path

from ...disk_trace import is_file, read_limited
from ...lazy_regex import regex

LISTS = (".repos", ".rosinstall")
PLAIN = (".yaml", ".yml", ".txt", ".list", ".vcs")
"""Endings under which some keep a list; many write none at all."""
TOLD = regex(r"(?i)repo|vcs|rosinstall|import|depend|underlay|upstream|source|packages|workspace")
"""What the name of a list says, where a folder has very many files of these endings."""
MAX_READ = 20
"""So many files of other names are read in a folder, whatever they are called."""
MAX_BYTES = 1_000_000
"""The largest .gitmodules or list that is read."""

HOLDS = regex(rb"^repositories:[ \t]*(?:#.*)?\r?$(?=(?s:.){0,4000}?^[ \t]+url:)", re.MULTILINE)
"""A list for vcs: `repositories:` with something that has a `url:`."""
INSTALLS = regex(rb"^-[ \t]+(?:git|hg|svn|bzr|tar):[ \t]*(?:\{|\r?$)", re.MULTILINE)
"""An entry for wstool."""


def lists_among(folder: Path, names: Sequence[str]) -> Iterator[Path]:
    """Yield the files of a folder that list repositories; raises OSError.

    A package's own folder holds data: there the ending alone counts.
    """
    yield from (folder / name for name in names if name.endswith(LISTS))
    if "package.xml" in names:
        return
    others = [name for name in names if name.endswith(PLAIN) or "." not in name.removeprefix(".")]
    if len(others) > MAX_READ:
        others = [name for name in others if TOLD.search(name)][:MAX_READ]
    yield from (folder / name for name in others if is_list(folder / name))


def is_list(path: Path) -> bool:
    """Return whether a file lists repositories, judging by what it holds; raises OSError."""
    data = read_limited(path)[1] if path.name != "CMakeLists.txt" and is_file(path) else None
    if not data or len(data) > MAX_BYTES:
        return False
    return HOLDS.search(data) is not None or INSTALLS.search(data) is not None

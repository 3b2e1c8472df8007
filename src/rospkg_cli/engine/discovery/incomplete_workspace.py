"""Whether more packages belong to a workspace than lie in it: lists for vcs and wstool, submodules that are empty."""

from __future__ import annotations

import os
from collections.abc import Iterator, Sequence
from pathlib import Path

from ...absent_paths import MAX_SUBMODULES, SUBMODULE
from ...disk_trace import is_file, is_folder, names_in, read_limited, scan
from ...leftovers import is_never_source

LISTS = (".repos", ".rosinstall")
MAX_BYTES = 1_000_000
"""The largest .gitmodules that is read."""


def lists_more_packages(around: Path | None, packages: Sequence[Path]) -> bool:
    """Return whether something in a workspace, in a folder right below it or above one of the packages says so.

    Where there is no workspace around, the folder that holds the packages is taken for it.
    """
    if around is None and not packages:
        return False
    top = around or Path(os.path.commonpath([package.parent for package in packages]))
    above = {folder for package in packages for folder in (package, *package.parents) if folder.is_relative_to(top)}
    return any(lists_packages(folder) for folder in {top, *above, *(children(top) if around else ())})


def children(folder: Path) -> Iterator[Path]:
    try:
        names = [entry.name for entry in scan(folder) if not is_never_source(entry.name)]
        yield from (folder / name for name in names if name[0] != "." and is_folder(folder / name))
    except OSError:
        return


def lists_packages(folder: Path) -> bool:
    try:
        names = [entry.name for entry in scan(folder) if not is_never_source(entry.name)]
        if any(name.endswith(LISTS) for name in names):
            return True
        paths = submodules(folder / ".gitmodules") if ".gitmodules" in names else []
    except OSError:
        return False
    return any(is_empty(folder / path) for path in paths[:MAX_SUBMODULES])


def submodules(path: Path) -> list[str]:
    """Return the folders that a .gitmodules names; raises OSError."""
    data = read_limited(path)[1] if is_file(path) else None
    return SUBMODULE.findall(data.decode("utf-8", "replace")) if data and len(data) <= MAX_BYTES else []


def is_empty(folder: Path) -> bool:
    """Return whether a submodule is not checked out: its folder is missing, or holds nothing."""
    try:
        return not is_folder(folder) or not names_in(folder)
    except OSError:
        return False

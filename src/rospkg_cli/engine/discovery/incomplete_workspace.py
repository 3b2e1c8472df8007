"""Whether more packages belong to a workspace than lie in it: lists for vcs and wstool, submodules that are empty."""

from __future__ import annotations

import os
from collections.abc import Iterator, Sequence
from pathlib import Path

from ...absent_paths import MAX_SUBMODULES, SUBMODULE

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
        yield from (each for each in folder.iterdir() if each.is_dir() and each.name[0] != ".")
    except OSError:
        return


def lists_packages(folder: Path) -> bool:
    try:
        if any(each.name.endswith(LISTS) for each in folder.iterdir()):
            return True
        modules = folder / ".gitmodules"
        paths = SUBMODULE.findall(modules.read_text("utf-8", "replace")) if is_small_file(modules) else []
    except OSError:
        return False
    return any(is_empty(folder / path) for path in paths[:MAX_SUBMODULES])


def is_small_file(path: Path) -> bool:
    return path.is_file() and path.stat().st_size <= MAX_BYTES


def is_empty(folder: Path) -> bool:
    """Return whether a submodule is not checked out: its folder is missing, or holds nothing."""
    try:
        return not folder.is_dir() or not any(folder.iterdir())
    except OSError:
        return False

"""The folder and the name of a new package, where a path stands in place of its name."""

from __future__ import annotations

import os
from pathlib import Path


def named_place(name: str, into: Path) -> tuple[str, Path]:
    """Return the name of the package and the folder it is written into: `.`, `src/my_pkg` and `my_pkg/` are paths."""
    if name not in (".", "..") and not {"/", os.sep}.intersection(name):
        return name, into
    target = Path(os.path.normpath(into / name))
    if target.name in ("", ".."):
        target = Path(os.path.normpath(target.absolute()))
    return target.name, target.parent


def is_empty(folder: Path) -> bool:
    """Return whether there is a folder with nothing in it but git's own."""
    try:
        return (
            folder.is_dir() and not folder.is_symlink() and {".git"}.issuperset(each.name for each in folder.iterdir())
        )
    except OSError:
        return False

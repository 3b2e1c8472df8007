"""The current folder and absolute paths, with symlinks kept, so that a linked package keeps its workspace."""

from __future__ import annotations

import os
from collections.abc import Iterable
from pathlib import Path

from .disk_trace import is_folder, real_path


def current_folder() -> Path:
    """Return the current folder as the shell shows it, with symlinks, where $PWD is right."""
    shown = os.environ.get("PWD", "")
    try:
        if Path(shown).is_absolute() and os.path.samefile(shown, os.curdir):  # noqa: PTH121
            return Path(shown)
    except (OSError, ValueError):
        pass
    return Path.cwd()


def absolute(path: Path) -> Path:
    """Return a typed path as an absolute one; with `..` in it, links are resolved as the system does."""
    if ".." in path.parts:
        return Path(real_path(path))
    return Path(os.path.normpath(current_folder() / path))


def common_folder(paths: Iterable[Path]) -> Path:
    """Return the innermost folder that holds all of some typed paths; their config is looked for from there."""
    common = Path(os.path.commonpath([absolute(path) for path in paths]))
    return common if is_folder(common) else common.parent

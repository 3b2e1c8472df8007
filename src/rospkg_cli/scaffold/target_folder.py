"""Where a package is written: whether colcon will find it there, and where its workspace is."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

from . import ScaffoldError
from .write import is_there, refuse_existing

MARKERS = ("COLCON_IGNORE", "AMENT_IGNORE")


def check_target(into: Path, target: Path, may_exist: bool = False) -> None:
    """Raise ScaffoldError where the folder has the package already, is a file, or belongs to another package."""
    if not may_exist:
        refuse_existing(target)
    elif is_there(target) and not target.is_dir():
        raise ScaffoldError(
            f"`{target}` is not a folder; it was left alone: choose another name, or a folder with --into"
        )
    for folder in (into.absolute(), *into.absolute().parents):
        if folder.exists() and not folder.is_dir():
            raise ScaffoldError(f"`{folder}` is a file; --into requires a folder")
        if (folder / "package.xml").is_file():
            raise ScaffoldError(
                f"`{folder}` is a package, and colcon does not look for packages inside another; "
                f"choose another folder: --into {folder.parent}"
            )


def hidden_from_colcon(into: Path) -> Iterator[str]:
    """Yield a sentence where a marker hides from colcon what lies in the folder."""
    for folder in (into.absolute(), *into.absolute().parents):
        for marker in MARKERS:
            if (folder / marker).exists():
                yield f"colcon will not see the package: `{folder / marker}` hides what lies below"
                return


def workspace_of(into: Path) -> Path:
    """Return where colcon is to be started: above the nearest `src`, else in the folder itself."""
    into = into.absolute()
    for folder in (into, *into.parents):
        if folder.name == "src":
            return folder.parent
    return into

"""Files in memory to a new folder on disk: all of them, or nothing."""

from __future__ import annotations

import os
import shutil
import tempfile
from collections.abc import Iterable
from pathlib import Path

from . import ScaffoldError
from .render import Written


def write_folder(target: Path, files: Iterable[Written]) -> None:
    """Write a folder that is not there yet, in one step; whatever interrupts it, nothing is left.

    Raises ScaffoldError where something stands at the target or the disk refuses.
    """
    made = missing_parents(target)
    beside = None
    try:
        target.parent.mkdir(parents=True, exist_ok=True)
        beside = Path(tempfile.mkdtemp(prefix=f".{target.name}.", dir=target.parent))
        for file in files:
            write(beside / file.path, file)
        beside.chmod(0o777 & ~umask())
        refuse_existing(target)
        beside.rename(target)
    except BaseException as error:
        if beside:
            shutil.rmtree(beside, ignore_errors=True)
        for folder in made:
            if folder.is_dir() and not any(folder.iterdir()):
                folder.rmdir()
        if isinstance(error, OSError):
            raise ScaffoldError(f"`{target}` can't be written: {error.strerror or error}; nothing was") from error
        raise


def refuse_existing(target: Path) -> None:
    """Raise ScaffoldError where something has the name already."""
    if target.exists() or target.is_symlink():
        raise ScaffoldError(
            f"`{target}` exists already and was left alone; choose another name, or a folder with --into"
        )


def missing_parents(target: Path) -> list[Path]:
    """Return the folders above the target that aren't there yet, the deepest first."""
    return [folder for folder in target.parents if not folder.exists()]


def write(path: Path, file: Written) -> None:
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_bytes(file.entry.data)
    if file.entry.executable:
        path.chmod(0o777 & ~umask())


def umask() -> int:
    mask = os.umask(0)
    os.umask(mask)
    return mask

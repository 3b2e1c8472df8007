"""Files in memory to a new folder on disk: all of them, or nothing."""

from __future__ import annotations

import os
import secrets
import shutil
from collections.abc import Iterable
from contextlib import suppress
from pathlib import Path

from ..engine.fixing.remove_leftovers import has_ended
from ..engine.fixing.signals import signals_ignored, stopped_by_signals
from ..engine.fixing.write import current_umask
from ..leftovers import STRAY
from . import ScaffoldError
from .render import RenderedFile


def write_folder(target: Path, files: Iterable[RenderedFile]) -> None:
    """Write a folder that is not there yet, in one step; whatever interrupts it, nothing is left.

    Raises ScaffoldError where something is at the target or the disk refuses.
    """
    made = missing_parents(target)
    beside = temporary_folder(target)
    remove_leftovers(target.parent)
    with stopped_by_signals():
        try:
            target.parent.mkdir(parents=True, exist_ok=True)
            for file in files:
                write(beside / file.path, file)
            refuse_existing(target)
            beside.rename(target)
        except BaseException as error:
            with signals_ignored():
                shutil.rmtree(beside, ignore_errors=True)
                for folder in made:
                    if folder.is_dir() and not any(folder.iterdir()):
                        folder.rmdir()
            if isinstance(error, OSError):
                raise ScaffoldError(f"`{target}` can't be written: {error.strerror or error}; nothing was") from error
            raise


def temporary_folder(target: Path) -> Path:
    """Return a name that nothing has, in the same folder; colcon looks into no hidden folder."""
    return target.parent / f".{target.name[:128]}.{os.getpid()}-{secrets.token_hex(6)}.rospkg-tmp"


def remove_leftovers(folder: Path) -> None:
    """Remove what runs of `new` that were killed left half written in a folder."""
    with suppress(OSError):
        for each in folder.iterdir():
            found = STRAY.fullmatch(each.name)
            if found and each.is_dir() and not each.is_symlink() and has_ended(each, int(found["process"])):
                shutil.rmtree(each, ignore_errors=True)


def refuse_existing(target: Path, more: str = "") -> None:
    """Raise ScaffoldError where something has the name already; `more` is what else can be done, after a comma."""
    if is_there(target):
        raise ScaffoldError(
            f"`{target}` exists already and was left alone; --diff shows what would change, --skip writes what is "
            f"missing, --force replaces and keeps what was there{more}"
        )


def is_there(path: Path) -> bool:
    """Return whether anything has the name, a link that leads nowhere included."""
    return path.is_symlink() or path.exists()


def missing_parents(target: Path) -> list[Path]:
    """Return the folders above the target that aren't there yet, the deepest first."""
    return [folder for folder in target.parents if not folder.exists()]


def write(path: Path, file: RenderedFile) -> None:
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_bytes(file.entry.data)
    if file.entry.is_executable:
        path.chmod(0o777 & ~current_umask())

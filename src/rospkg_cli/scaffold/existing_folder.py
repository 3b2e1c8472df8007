"""A package into a folder that is there: what differs from it, and how files get in without any loss."""

from __future__ import annotations

import shutil
from collections.abc import Callable, Iterable
from contextlib import suppress
from pathlib import Path

from ..disk import read_entry
from ..engine.fixing.signals import signals_ignored, stopped_by_signals
from ..light_dataclasses import dataclass
from ..tree import TreeEntry
from . import ScaffoldError
from .render import RenderedFile
from .write import is_there, temporary_folder, write


@dataclass(frozen=True)
class FolderDifference:
    """The files of a package that a folder lacks, has with other content, and has already."""

    missing: tuple[RenderedFile, ...] = ()
    other: tuple[tuple[RenderedFile, TreeEntry], ...] = ()
    """With the file that is there."""
    same: tuple[RenderedFile, ...] = ()


def compare(folder: Path, files: Iterable[RenderedFile]) -> FolderDifference:
    """Compare; raises ScaffoldError where a path is not a file, or can't be read."""
    missing, other, same = [], [], []
    for file in files:
        path = folder / file.path
        refuse_obstacles(folder, path)
        try:
            there = read_entry(path)
        except FileNotFoundError:
            missing.append(file)
            continue
        except OSError as error:
            raise ScaffoldError(f"`{path}` can't be read: {error.strerror or error}; nothing was written") from error
        if (there.data, there.is_executable) == (file.entry.data, file.entry.is_executable):
            same.append(file)
        else:
            other.append((file, there))
    return FolderDifference(tuple(missing), tuple(other), tuple(same))


def refuse_obstacles(folder: Path, path: Path) -> None:
    """Raise ScaffoldError for a link or a file where a folder must be, and for anything but a file at the path."""
    for parent in list(path.parents)[: len(path.relative_to(folder).parts) - 1]:
        if parent.is_symlink() or (parent.exists() and not parent.is_dir()):
            what = "a link, and what lies behind it is left alone" if parent.is_symlink() else "not a folder"
            raise ScaffoldError(f"`{parent}` is {what}; move it away, and then try again")
    if path.is_dir() or (path.is_symlink() and not path.exists()) or (path.exists() and not path.is_file()):
        raise ScaffoldError(
            f"`{path}` is not a file, and a file of that name would be written; move it away, then try again"
        )


def write_into(folder: Path, difference: FolderDifference, replace: bool) -> Path | None:
    """Write what is missing and, where `replace` says so, what differs: all of it or nothing.

    What is replaced is kept; the folder where is returned, None where nothing was. Raises ScaffoldError.
    """
    folder = folder.resolve()
    replaced = tuple(file for file, _ in difference.other) if replace else ()
    for file in replaced:
        if (folder / file.path).is_symlink():
            raise ScaffoldError(f"`{folder / file.path}` is a link, and would become a file; move it away first")
    kept = free_name(folder) if replaced else None
    stage = temporary_folder(folder)
    undo: list[Callable[[], object]] = [lambda: shutil.rmtree(stage, ignore_errors=True)]
    with stopped_by_signals():
        try:
            for file in (*difference.missing, *replaced):
                write(stage / file.path, file)
            if kept:
                for file in replaced:
                    move(folder / file.path, kept / file.path, undo)
                put(kept / "COLCON_IGNORE", undo)
            for file in (*difference.missing, *replaced):
                move(stage / file.path, folder / file.path, undo)
        except BaseException as error:
            take_back(undo)
            if isinstance(error, OSError):
                raise ScaffoldError(f"`{folder}` can't be written: {error.strerror or error}; nothing was") from error
            raise
        take_back(undo[:1])
    return kept


def take_back(undo: list[Callable[[], object]]) -> None:
    """Undo what was done, the last first; whatever fails, the rest is undone."""
    with signals_ignored():
        for step in reversed(undo):
            with suppress(OSError):
                step()


def free_name(folder: Path) -> Path:
    """Return a free name next to a folder: `NAME.orig`, `NAME.orig2`, …"""
    number = 1
    while is_there(kept := folder.with_name(f"{folder.name}.orig{number if number > 1 else ''}")):
        number += 1
    return kept


def move(source: Path, target: Path, undo: list[Callable[[], object]]) -> None:
    """Move a file to where nothing is, and remember the way back."""
    make_folder(target.parent, undo)
    if is_there(target):
        raise ScaffoldError(f"`{target}` was written by someone else meanwhile; nothing was by us: try again")
    undo.append(lambda: target.rename(source) if target.exists() else None)
    source.rename(target)


def put(path: Path, undo: list[Callable[[], object]]) -> None:
    undo.append(lambda: path.unlink(missing_ok=True))
    path.touch()


def make_folder(folder: Path, undo: list[Callable[[], object]]) -> None:
    """Make a folder and those above it; the way back takes away those that are empty again."""
    for each in reversed([f for f in (folder, *folder.parents) if not f.exists()]):
        undo.append(each.rmdir)  # fails, and leaves it, where something is in it
        each.mkdir()

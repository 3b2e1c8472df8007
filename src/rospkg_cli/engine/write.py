"""Write changes to disk: each file at once or not at all, in the mode it had, and never over somebody else's edit."""

from __future__ import annotations

import os
import stat
import tempfile
from contextlib import suppress
from pathlib import Path

from ..tree import Entry, Tree
from .apply import Changes


class WriteError(Exception):
    """A file that was not written; the message says which and why. Files before it are written whole."""


def write_changes(root: Path, tree: Tree, changes: Changes) -> list[str]:
    """Write every change and return the paths written; raises WriteError at the first that can't be."""
    written: list[str] = []
    for path, entry in sorted(changes.items()):
        check_unchanged(root / path, tree, path)
        try:
            if entry is None:
                (root / path).unlink()
            else:
                write_file(root / path, entry)
        except OSError as error:
            done = f"; written before it: {', '.join(written)}" if written else "; nothing was written"
            raise WriteError(f"`{path}` can't be written: {error.strerror or error}{done}") from error
        written.append(path)
    return written


def check_unchanged(target: Path, tree: Tree, path: str) -> None:
    """Raise WriteError where the file on disk is no longer the one that was read."""
    try:
        before: bytes | None = tree.entry(path).data
    except OSError:
        before = None
    now = target.read_bytes() if target.is_file() else None
    if now != before:
        raise WriteError(f"`{path}` was changed by someone else meanwhile; it was left alone: run again")


def write_file(target: Path, entry: Entry) -> None:
    """Replace a file in one step; a link stays a link to the file that is replaced. Raises OSError."""
    target = target.resolve() if target.is_symlink() else target
    target.parent.mkdir(parents=True, exist_ok=True)
    mode = stat.S_IMODE(target.stat().st_mode) if target.exists() else 0o666 & ~current_umask()
    mode = mode | ((mode & 0o444) >> 2) if entry.executable else mode & ~0o111
    if not mode & 0o222:
        raise PermissionError(13, "the file is read-only")
    descriptor, name = tempfile.mkstemp(dir=target.parent, prefix=f".{target.name}.")
    try:
        with os.fdopen(descriptor, "wb") as stream:
            stream.write(entry.data)
            stream.flush()
            os.fsync(stream.fileno())
        Path(name).chmod(mode)
        Path(name).replace(target)
    except BaseException:
        with suppress(OSError):
            Path(name).unlink()
        raise


def write_text(target: Path, text: str) -> None:
    """Write a report or a baseline; raises WriteError."""
    try:
        write_file(target, Entry("file", text.encode()))
    except OSError as error:
        raise WriteError(f"`{target}` can't be written: {error.strerror or error}") from error


def current_umask() -> int:
    mask = os.umask(0)
    os.umask(mask)
    return mask

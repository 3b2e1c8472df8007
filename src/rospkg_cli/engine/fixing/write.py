"""Write changes to disk: each file at once or not at all, in the mode it had, and never over somebody else's edit."""

from __future__ import annotations

import os
import stat
import tempfile
from collections.abc import Callable
from contextlib import suppress
from pathlib import Path

from ...fence import Fence
from ...tree import LeadsOutError, Tree, TreeEntry
from ...user_error import UserError
from .apply import Changes


class WriteError(UserError):
    """Files that were not written; the message says which and why. All others are written whole."""


class ChangedError(OSError):
    """The file on disk is not the one that was read."""


def write_changes(root: Path, tree: Tree, changes: Changes, fence: Fence | None = None) -> list[str]:
    """Write every change that can be written and return the paths; raises WriteError for those that can't.

    `fence` says how far links may lead; without one, not out of `root` and its repository.
    """
    fence = fence or Fence(root)
    written: list[str] = []
    faults: list[str] = []
    for path, entry in sorted(changes.items()):
        try:
            write_change(root / path, path, tree, entry, fence)
        except (ChangedError, LeadsOutError) as error:
            faults.append(str(error))
        except OSError as error:
            faults.append(f"`{path}` can't be written: {error.strerror or error}")
        else:
            written.append(path)
    if faults:
        others = f"; {len(written)} other{'s' * (len(written) > 1)} written" if written else "; nothing was written"
        raise WriteError("; ".join(faults) + others)
    return written


def write_change(target: Path, path: str, tree: Tree, entry: TreeEntry | None, fence: Fence) -> None:
    """Write one change; raises OSError."""
    fence.check(path)
    if (target.exists() or target.is_symlink()) and not target.is_file():
        raise ChangedError(f"`{path}` exists and is not a file; it was not changed")
    try:
        before: bytes | None = tree.entry(path).data
    except FileNotFoundError:
        before = None

    def check() -> None:
        now = target.read_bytes() if target.is_file() else None
        if now != before and not (entry and now == entry.data):
            raise ChangedError(f"`{path}` was changed by someone else meanwhile; it was left alone: run again")

    if entry is None:
        check()
        target.unlink()
    else:
        write_file(target, entry, check)


def write_file(target: Path, entry: TreeEntry, check: Callable[[], None] = lambda: None) -> None:
    """Replace a file in one step; a link stays a link to the file that is replaced. Raises OSError.

    `check` may object at the last moment. A process that is killed leaves at most a file that
    `leftovers.STRAY` knows, for `remove_strays`.
    """
    target = target.resolve() if target.is_symlink() else target
    target.parent.mkdir(parents=True, exist_ok=True)
    mode = stat.S_IMODE(target.stat().st_mode) if target.exists() else 0o666 & ~current_umask()
    mode = mode | ((mode & 0o444) >> 2) if entry.is_executable else mode & ~0o111
    if not mode & 0o222:
        raise PermissionError(13, "the file is read-only")
    start = os.fsdecode(os.fsencode(target.name)[:128])
    descriptor, name = tempfile.mkstemp(dir=target.parent, prefix=f".{start}.{os.getpid()}-", suffix=".rospkg-tmp")
    try:
        with os.fdopen(descriptor, "wb") as stream:
            stream.write(entry.data)
            stream.flush()
            os.fsync(stream.fileno())
        Path(name).chmod(mode)
        check()
        Path(name).replace(target)
    except BaseException:
        with suppress(OSError):
            Path(name).unlink()
        raise


def write_text(target: Path, text: str) -> None:
    """Write a report or a baseline; raises WriteError."""
    try:
        write_file(target, TreeEntry("file", text.encode("utf-8", "backslashreplace")))
    except OSError as error:
        raise WriteError(f"`{target}` can't be written: {error.strerror or error}") from error


def current_umask() -> int:
    mask = os.umask(0)
    os.umask(mask)
    return mask

"""What lint asks of the disk: every question goes through here, and can be kept with its answer.

A run whose questions would all be answered as before would end as before; `cache` builds on that. Paths are absolute,
or relative to the current folder. Nothing is imported that an interpreter has not loaded at its start.
"""

from __future__ import annotations

import os
import stat

TYPE_CHECKING = False  # typing's own would cost a start some milliseconds
if TYPE_CHECKING:
    AnyPath = str | os.PathLike[str]

MAX_BYTES = 4_000_000
"""Larger files are listed, not read."""

ABSENT = "-"
"""The answer of the disk where there is nothing, or where it refuses to tell."""


class Trace:
    """The questions of a run with their answers. A question is a letter for what is asked, and a path."""

    def __init__(self) -> None:
        self.answers: dict[str, str] = {}
        self.signatures: dict[str, str] = {}
        """What a file that was read looked like from outside; "" where it was too young to tell."""
        self.is_whole = True
        """False where it can't stand for the run: one question was answered in two ways."""

    def note(self, question: str, answer: str) -> None:
        if self.answers.setdefault(question, answer) != answer:
            self.is_whole = False

    def add(self, other: Trace) -> None:
        """Add what another process asked."""
        for question, answer in other.answers.items():
            self.note(question, answer)
        self.signatures |= other.signatures
        self.is_whole &= other.is_whole


_trace: Trace | None = None


def start_trace() -> Trace:
    """From now on, keep the questions of this process."""
    global _trace
    _trace = Trace()
    return _trace


def current_trace() -> Trace | None:
    return _trace


def stop_trace() -> None:
    global _trace
    _trace = None


def note(question: str, answer: str) -> None:
    if _trace is not None:
        _trace.note(question, answer)


def kind_of(path: AnyPath) -> str:
    """Return what a path leads to: `f` for a file, `d` for a folder, `o` for others, `-` for nothing."""
    try:
        mode = os.stat(path).st_mode
        found = "f" if stat.S_ISREG(mode) else "d" if stat.S_ISDIR(mode) else "o"
    except (OSError, ValueError):
        found = ABSENT
    note(f"k{os.fspath(path)}", found)
    return found


def exists(path: AnyPath) -> bool:
    return kind_of(path) != ABSENT


def is_file(path: AnyPath) -> bool:
    return kind_of(path) == "f"


def is_folder(path: AnyPath) -> bool:
    return kind_of(path) == "d"


def is_there(path: AnyPath) -> bool:
    """Return whether there is anything of that name, a dead link too."""
    found = os.path.lexists(path)
    note(f"x{os.fspath(path)}", str(found))
    return found


def link_target(path: AnyPath) -> str | None:
    """Return what a symlink says; None where there is none."""
    try:
        target: str | None = os.readlink(path)
    except OSError:
        target = None
    note(f"t{os.fspath(path)}", ABSENT if target is None else f"+{target}")
    return target


def real_path(path: AnyPath) -> str:
    """Return a path without symlinks, as far as it exists."""
    found = os.path.realpath(path)
    note(f"r{os.fspath(path)}", found)
    return found


CACHE_TAG = "CACHEDIR.TAG"
KEPT = ("run-", "code-", "packages-", "pruned")
"""How the names of our own files in a cache begin. It may lie in a package, and each run writes some: none counts."""


def scan(folder: AnyPath) -> list[os.DirEntry[str]]:
    """Return the entries of a folder, by name; raises OSError. What links lead to is asked, too.

    Callers pass over names that are never source: a listing that differs only in these counts as the same.
    """
    try:
        with os.scandir(folder) as listing:
            entries = sorted(listing, key=lambda entry: entry.name)
        if any(entry.name == CACHE_TAG for entry in entries):
            entries = [entry for entry in entries if not entry.name.startswith(KEPT)]
    except OSError as error:
        note(f"l{os.fspath(folder)}", f"!{error.errno}")
        raise
    if _trace is not None:
        note(f"l{os.fspath(folder)}", "/".join(f"{mark_of(entry)}{entry.name}" for entry in entries))
        for entry in entries:
            if entry.is_symlink():
                kind_of(entry.path)
    return entries


def mark_of(entry: os.DirEntry[str]) -> str:
    try:
        if entry.is_symlink():
            return "l"
        return "f" if entry.is_file(follow_symlinks=False) else "d" if entry.is_dir(follow_symlinks=False) else "o"
    except OSError:
        return "o"


def names_in(folder: AnyPath) -> list[str]:
    """Return the names in a folder, sorted; raises OSError."""
    try:
        found = sorted(os.listdir(folder))
    except OSError as error:
        note(f"n{os.fspath(folder)}", f"!{error.errno}")
        raise
    note(f"n{os.fspath(folder)}", "/".join(found))
    return found


def read_limited(path: AnyPath) -> tuple[os.stat_result, bytes | None]:
    """Return the state and the bytes of a regular file, None for more than MAX_BYTES; raises OSError."""
    return read_noted("b", path, MAX_BYTES)


def read(path: AnyPath) -> bytes:
    """Return the bytes of a regular file; raises OSError."""
    return read_noted("w", path, None)[1] or b""


def read_noted(letter: str, path: AnyPath, limit: int | None) -> tuple[os.stat_result, bytes | None]:
    question = f"{letter}{os.fspath(path)}"
    try:
        found = os.stat(path)
        if not stat.S_ISREG(found.st_mode):
            raise FileNotFoundError(2, os.strerror(2), os.fspath(path))
        data = None
        if limit is None or found.st_size <= limit:
            data = bytes_of(path, found.st_size)
    except OSError as error:
        note(question, f"!{error.errno}")
        raise
    if _trace is not None:
        _trace.note(question, f"{int(bool(found.st_mode & 0o111))}{found.st_size if data is None else digest(data)}")
        _trace.signatures[question] = signature(found)
    return found, data


def bytes_of(path: AnyPath, size: int) -> bytes:
    """Return the bytes of a file that may have grown; raises OSError. A stream would take as long as the reading."""
    handle = os.open(path, os.O_RDONLY | getattr(os, "O_BINARY", 0))
    try:
        data = os.read(handle, size + 1)
        while len(data) > size:
            size = 2 * len(data)
            data += os.read(handle, size + 1 - len(data))
    finally:
        os.close(handle)
    return data


def recall(path: AnyPath, answer: str, known: str) -> bool:
    """Return whether a file that an earlier run read looks as it did then; if so, this run counts as having read it."""
    try:
        found = os.stat(path)
    except (OSError, ValueError):
        return False
    if look_of(found) != known:
        return False
    if _trace is not None:
        _trace.note(f"b{os.fspath(path)}", answer)
        _trace.signatures[f"b{os.fspath(path)}"] = known
    return True


def digest(data: bytes) -> str:
    from hashlib import blake2b

    return blake2b(data, digest_size=16).hexdigest()


YOUNG = 2_000_000_000
"""Nanoseconds for which a file may change again without looking different: clocks of file systems are coarse."""


def signature(found: os.stat_result) -> str:
    """Return what changes when a file does; "" for one that changed a moment ago, or in the future."""
    from time import time_ns

    if max(found.st_mtime_ns, found.st_ctime_ns) > time_ns() - YOUNG:
        return ""
    return look_of(found)


def look_of(found: os.stat_result) -> str:
    """Return all that a file shows of itself without being read."""
    return f"{found.st_mtime_ns} {found.st_ctime_ns} {found.st_size} {found.st_ino} {found.st_mode}"

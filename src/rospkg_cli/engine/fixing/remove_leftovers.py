"""Take away what a run that was killed while it wrote left behind: its own temporary files, of processes that ended."""

from __future__ import annotations

import os
import time
from collections.abc import Iterable, Iterator
from contextlib import suppress
from pathlib import Path

from ...leftovers import SKIPPED, STRAY

OLD = 600.0
"""Seconds after which a temporary file counts as left over, where its process can't be checked."""


def remove_leftovers(folders: Iterable[Path]) -> None:
    """Remove them from packages; a file that can't be removed is left."""
    for stray, process in leftovers_below(folders):
        if has_ended(stray, process):
            with suppress(OSError):
                stray.unlink()


def leftovers_below(folders: Iterable[Path]) -> Iterator[tuple[Path, int]]:
    """Yield our temporary files below some folders, with the number of the process that made each."""
    waiting = list(folders)
    while waiting:
        try:
            with os.scandir(waiting.pop()) as listing:
                entries = list(listing)
        except OSError:
            continue
        for entry in entries:
            if entry.is_dir(follow_symlinks=False) and entry.name not in SKIPPED:
                waiting.append(Path(entry.path))
            elif found := STRAY.fullmatch(entry.name):
                yield Path(entry.path), int(found["process"])


def has_ended(stray: Path, process: int) -> bool:
    """Return whether the process that wrote a file has ended."""
    if os.name != "posix":
        with suppress(OSError):
            return time.time() - stray.stat().st_mtime > OLD
        return False
    try:
        os.kill(process, 0)
    except (ProcessLookupError, OverflowError):
        return True
    except PermissionError:
        return False
    return False

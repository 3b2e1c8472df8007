"""Keep the cache small: what no run asked for in a month goes, and the oldest of what is too much."""

from __future__ import annotations

import os
import time
from collections.abc import Iterator

from ..disk_trace import KEPT
from .kept_file import STRAY, remove, save

MAX_TOTAL = 100_000_000
"""Bytes of all files together."""

MAX_AGE = 30 * 86_400
"""Seconds without being served or written."""

MAX_STRAY_AGE = 600
"""Seconds; a file that is still being written is younger."""

EVERY = 3_600
"""Seconds between two looks."""


def prune_sometimes(folder: str) -> None:
    """Prune, if that was not done within the last hour."""
    mark = os.path.join(folder, "pruned")
    try:
        if 0 <= time.time() - os.stat(mark).st_mtime < EVERY:
            return
    except OSError:
        pass
    save(mark, [""])
    prune(folder)


def prune(folder: str) -> None:
    """Remove what is old or was left half written; then the oldest files until the others are few enough."""
    now, total = time.time(), 0
    for changed, size, path in sorted(kept_files(folder), reverse=True):
        total += size
        if total > MAX_TOTAL or now - changed > (MAX_STRAY_AGE if path.endswith(STRAY) else MAX_AGE):
            total -= remove(path)


def clear(folder: str) -> int:
    """Remove all files of the cache; return how many bytes that gave back."""
    return sum(remove(path) for _, _, path in list(kept_files(folder)))


def kept_files(folder: str) -> Iterator[tuple[float, int, str]]:
    """Yield the time of the last use, the size in bytes and the path of each file."""
    try:
        with os.scandir(folder) as entries:
            for entry in entries:
                if entry.name.startswith(KEPT) and entry.is_file(follow_symlinks=False):
                    found = entry.stat(follow_symlinks=False)
                    yield found.st_mtime, found.st_size, entry.path
    except OSError:
        return

"""Three versions of one file to one: yours, what was written once, and what would be written now."""

from __future__ import annotations

import subprocess
import tempfile
from collections.abc import Sequence
from pathlib import Path

from ..light_dataclasses import dataclass
from . import ScaffoldError
from .line_digests import digests, rebuilt
from .merge_dependencies import with_all_dependencies

SECONDS = 60


@dataclass(frozen=True)
class MergedLines:
    data: bytes
    conflicts: int
    """Places with `<<<<<<<` in them."""


def merge_lines(yours: bytes, written: Sequence[str], new: bytes) -> MergedLines | None:
    """Return the file with the changes of both sides since it was written; None where one of them is no text.

    `written` holds the digests of its lines as they were written, () where that is unknown: then every place that
    differs is a conflict. Line ends are yours. Raises ScaffoldError where git can't be run.
    """
    if has_windows_ends(yours):
        new = new.replace(b"\r\n", b"\n").replace(b"\n", b"\r\n")
    now = digests(new)
    if tuple(written) == now or yours == new:
        return MergedLines(yours, 0)
    if tuple(written) == digests(yours):
        return MergedLines(new, 0)
    base = rebuilt(written, new, yours)
    base = base.replace(b"\n", b"\r\n") if has_windows_ends(yours) else base
    merged = git_merge(yours, base, new)
    if merged is None or not merged.conflicts:
        return merged
    data, solved = with_all_dependencies(merged.data, base)
    return MergedLines(data, merged.conflicts - solved)


def has_windows_ends(data: bytes) -> bool:
    """Return whether every line ends as Windows writes it."""
    return 0 < data.count(b"\n") == data.count(b"\r\n")


def git_merge(yours: bytes, base: bytes, new: bytes) -> MergedLines | None:
    with tempfile.TemporaryDirectory(prefix="rospkg-merge-") as place:
        paths = [Path(place, name) for name in ("yours", "written", "rospkg")]
        for path, data in zip(paths, (yours, base, new), strict=True):
            path.write_bytes(data)
        labels = [word for name in ("yours", "as it was written", "rospkg") for word in ("-L", name)]
        command = ["git", "-c", "merge.conflictStyle=merge", "merge-file", "-p", "-q", *labels, *map(str, paths)]
        try:
            done = subprocess.run(command, cwd=place, capture_output=True, check=False, timeout=SECONDS)
        except FileNotFoundError:
            raise ScaffoldError(
                "git is not installed, and --update merges files with it; nothing was written"
            ) from None
        except subprocess.TimeoutExpired:
            raise ScaffoldError(f"git did not merge a file within {SECONDS} seconds; nothing was written") from None
    return MergedLines(done.stdout, done.returncode) if done.returncode < 128 else None

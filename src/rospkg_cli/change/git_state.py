"""Whether git can bring back what is about to change."""

from __future__ import annotations

import subprocess
from collections.abc import Iterable
from pathlib import Path

from ..fence import repository_of
from . import ChangeError

MAX_NAMED = 3

STATUS = (
    "git",
    "-c",
    "core.fsmonitor=false",  # a repository may name a program there
    "--no-optional-locks",
    "status",
    "--porcelain",
    "-z",
    "--untracked-files=all",
    "--no-renames",
)


def require_clean_everywhere(root: Path, paths: Iterable[str]) -> None:
    """Raise ChangeError where git could not bring back files or folders below a root; each may be in a repository."""
    found: dict[Path, list[str]] = {}
    for path in paths:
        above = (root / path).parent
        repository = repository_of(above) or above
        found.setdefault(repository, []).append((root / path).relative_to(repository).as_posix())
    for repository, inside in sorted(found.items()):
        require_clean(repository, inside)


def require_clean(folder: Path, paths: Iterable[str] | None = None) -> None:
    """Raise ChangeError where git could not bring files below a folder back: changes are not committed, or no git.

    `paths` are files relative to the folder: only their changes count then; None is the whole repository.
    """
    dirty = uncommitted(folder, paths)
    if dirty is None:
        raise ChangeError(
            f"`{folder}` is in no git repository, so nothing could bring the old files back; --allow-dirty goes ahead"
        )
    if dirty:
        shown = ", ".join(f"`{path}`" for path in dirty[:MAX_NAMED])
        more = f" and {len(dirty) - MAX_NAMED} more" if len(dirty) > MAX_NAMED else ""
        raise ChangeError(f"{shown}{more}: changes are not committed; commit or stash them, or give --allow-dirty")


def uncommitted(folder: Path, paths: Iterable[str] | None = None) -> list[str] | None:
    """Return what git shows as changed or untracked, relative to the repository; None where there is none."""
    chosen = None if paths is None else sorted(paths)
    if chosen == []:
        return []
    command = [*STATUS, *(("--", *(f":(literal){path}" for path in chosen)) if chosen else ())]
    try:
        done = subprocess.run(command, cwd=folder, capture_output=True, check=False, timeout=60)
    except (OSError, subprocess.TimeoutExpired):
        return None
    if done.returncode:
        return None
    lines = done.stdout.decode("utf-8", "surrogateescape").split("\0")
    return [line[3:] for line in lines if line]

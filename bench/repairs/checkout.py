"""The tree of a commit, written into a folder from a bare repository that may lack large files."""

from __future__ import annotations

import os
import subprocess
from collections.abc import Iterator
from pathlib import Path

MOST = 1_000_000
"""Bytes: a longer file is data that no rule reads, and becomes an empty one."""


def checkout(git_dir: Path, commit: str, folder: Path) -> None:
    """Write the files and links of a commit; raises CalledProcessError where the commit is not there."""
    entries = list(listing(git_dir, commit))
    asked = "".join(f"{sha}\n" for _, sha, _ in entries).encode()
    sizes = git(git_dir, "cat-file", "--batch-check=%(objecttype) %(objectsize)", given=asked).decode().splitlines()
    small = [entry for entry, size in zip(entries, sizes, strict=True) if is_small(size)]
    texts = batch(git(git_dir, "cat-file", "--batch", given="".join(f"{sha}\n" for _, sha, _ in small).encode()))
    contents = dict(zip((path for _, _, path in small), texts, strict=True))
    for mode, _, path in entries:
        target = folder / path
        target.parent.mkdir(parents=True, exist_ok=True)
        if mode == "120000":
            link(folder, target, contents.get(path, b""))
        else:
            target.write_bytes(contents.get(path, b""))
            target.chmod(0o755 if mode == "100755" else 0o644)


def listing(git_dir: Path, commit: str) -> Iterator[tuple[str, str, str]]:
    """Yield mode, object and path of every file."""
    for record in git(git_dir, "ls-tree", "-r", "-z", commit).decode("utf-8", "surrogateescape").split("\0"):
        head, _, path = record.partition("\t")
        if path:
            mode, kind, sha = head.split()
            if kind == "blob":
                yield mode, sha, path


def is_small(size: str) -> bool:
    kind, _, count = size.partition(" ")
    return kind == "blob" and int(count) <= MOST


def batch(output: bytes) -> Iterator[bytes]:
    """Yield the objects in an output of `git cat-file --batch`."""
    at = 0
    while at < len(output):
        end = output.index(b"\n", at)
        size = int(output[at:end].split()[2])
        yield output[end + 1 : end + 1 + size]
        at = end + size + 2


def link(folder: Path, target: Path, data: bytes) -> None:
    """Make a symbolic link, if it stays inside the folder."""
    goal = data.decode("utf-8", "surrogateescape")
    inside = Path(os.path.normpath(target.parent / goal))
    if goal and not Path(goal).is_absolute() and inside.is_relative_to(folder) and not target.exists():
        target.symlink_to(goal)


def git(git_dir: Path, *arguments: str, given: bytes = b"") -> bytes:
    command = ["git", "--git-dir", str(git_dir), *arguments]
    environment = {**os.environ, "GIT_NO_LAZY_FETCH": "1"}
    return subprocess.run(command, input=given, capture_output=True, check=True, env=environment).stdout

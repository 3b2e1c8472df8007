"""A folder of files, on disk or in memory: path to entry, listing, and a view of a sub-folder.

Text is decoded once; what is needed to write it back as it was (encoding, byte order mark, line ends) stays with it.
"""

from __future__ import annotations

import os
import stat
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import Literal, Protocol

from .text import Text, decode

Kind = Literal["file", "dir", "link"]

SKIPPED = frozenset({".git", ".hg", ".svn", ".venv", "venv", "node_modules", "__pycache__", ".tox", ".mypy_cache"})
"""Folders that are never a package's own files."""

BUILT = frozenset({"build", "install", "log"})
"""colcon's output folders; left out where colcon left its mark in them."""

MAX_BYTES = 4_000_000
"""Larger files are listed, not read."""


@dataclass(frozen=True)
class Entry:
    """One file: its bytes, whether it may be executed, and its text where it has one."""

    kind: Kind
    data: bytes
    mode: int = 0o644

    @cached_property
    def text(self) -> Text:
        """The decoded text; raises UnicodeError where the bytes are none."""
        return decode(self.data)

    @property
    def executable(self) -> bool:
        return bool(self.mode & 0o111)


class Tree(Protocol):
    """Files below one folder. Paths are relative to it, with `/`."""

    def files(self) -> Mapping[str, Kind]:
        """Return every file and link below the folder, with its kind; folders only where they are empty."""

    def entry(self, path: str) -> Entry:
        """Return one entry; raises FileNotFoundError."""

    def sub(self, folder: str) -> Tree:
        """Return the view of a folder."""


@dataclass
class MemoryTree:
    """A tree of a plain dict; a str is the text of a file."""

    content: dict[str, Entry]

    @classmethod
    def of(cls, files: Mapping[str, str | bytes | Entry]) -> MemoryTree:
        return cls({path: as_entry(value) for path, value in files.items()})

    def files(self) -> Mapping[str, Kind]:
        return {path: entry.kind for path, entry in self.content.items()}

    def entry(self, path: str) -> Entry:
        try:
            return self.content[path]
        except KeyError:
            raise FileNotFoundError(path) from None

    def sub(self, folder: str) -> MemoryTree:
        if not folder:
            return self
        prefix = folder + "/"
        return MemoryTree({p[len(prefix) :]: e for p, e in self.content.items() if p.startswith(prefix)})


def as_entry(value: str | bytes | Entry) -> Entry:
    if isinstance(value, Entry):
        return value
    if isinstance(value, bytes):
        return Entry("file", value)
    return Entry("file", value.encode(), 0o755 if value.startswith("#!") else 0o644)


@dataclass
class DiskTree:
    """A folder on disk. Nothing is read before it is asked for, and nothing is read twice."""

    root: Path

    def __post_init__(self) -> None:
        self._entries: dict[str, Entry] = {}

    @cached_property
    def _files(self) -> dict[str, Kind]:
        return dict(sorted(walk(self.root, "")))

    def files(self) -> Mapping[str, Kind]:
        return self._files

    def entry(self, path: str) -> Entry:
        if path not in self._entries:
            self._entries[path] = read_entry(self.root / path)
        return self._entries[path]

    def sub(self, folder: str) -> DiskTree:
        return DiskTree(self.root / folder) if folder else self


def read_entry(path: Path) -> Entry:
    """Read one file; raises OSError."""
    found = path.stat()
    if not stat.S_ISREG(found.st_mode):
        raise FileNotFoundError(str(path))
    data = path.read_bytes() if found.st_size <= MAX_BYTES else b""
    return Entry("link" if path.is_symlink() else "file", data, stat.S_IMODE(found.st_mode))


def walk(root: Path, prefix: str) -> Iterator[tuple[str, Kind]]:
    """Yield the files below a folder; neither colcon's output nor links to folders are followed."""
    try:
        entries = sorted(os.scandir(root / prefix), key=lambda e: e.name)
    except OSError:
        return
    if not entries and prefix:
        yield prefix.rstrip("/"), "dir"
    for entry in entries:
        path = prefix + entry.name
        if entry.is_dir(follow_symlinks=False):
            if entry.name not in SKIPPED and not is_built(entry):
                yield from walk(root, path + "/")
        else:
            yield path, "link" if entry.is_symlink() else "file"


def is_built(entry: os.DirEntry[str]) -> bool:
    return entry.name in BUILT and os.path.exists(os.path.join(entry.path, "COLCON_IGNORE"))  # noqa: PTH110, PTH118

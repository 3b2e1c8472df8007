"""Files below one folder as a path → entry mapping, on disk or in memory.

Text is decoded once; what is needed to write it back as it was (encoding, byte order mark, line ends) stays with it.
`disk` holds the tree of a real folder.
"""

from __future__ import annotations

from collections.abc import Mapping
from functools import cached_property
from typing import Literal, Protocol

from .encoding import DecodedText, decode
from .light_dataclasses import dataclass

Kind = Literal["file", "link", "outside", "dir", "linked-dir", "linked-package", "other"]
"""The kind of a path: a regular file; a link to one that may be read; a link to one out of the package and its
repository; an empty folder; a link to a folder, or to one with an `__init__.py`; anything else (a dead link, a FIFO, a
socket, a device)."""

LINKED: frozenset[Kind] = frozenset({"linked-dir", "linked-package"})

READABLE: frozenset[Kind] = frozenset({"file", "link"})

FILES: frozenset[Kind] = READABLE | {"outside"}
"""What counts as a file of the package; one that leads outside is never read."""

EXISTING: frozenset[Kind] = FILES | LINKED | {"dir"}
"""What a build finds; it can't install a dead link or a FIFO."""


class SkippedError(OSError):
    """A file that exists and is not read on purpose; the message is a whole sentence."""


class LeadsOutError(SkippedError):
    """A link that leads out of the package and its repository."""


@dataclass(frozen=True)
class TreeEntry:
    """One file: its bytes, whether it may be executed, and its text where it has one."""

    kind: Kind
    data: bytes
    mode: int = 0o644
    skipped: str = ""
    """Why `data` was not read, as a sentence; "" where it was."""

    @cached_property
    def text(self) -> DecodedText:
        """The decoded text; raises UnicodeError where the bytes are none, SkippedError where they were not read."""
        if self.skipped:
            raise SkippedError(self.skipped)
        return decode(self.data)

    @property
    def is_executable(self) -> bool:
        return bool(self.mode & 0o111)


class Tree(Protocol):
    """Files below one folder. Paths are relative to it, with `/`."""

    def files(self) -> Mapping[str, Kind]:
        """Return everything below the folder with its kind; folders only where they are empty."""

    def entry(self, path: str) -> TreeEntry:
        """Return one file; raises FileNotFoundError where there is none, SkippedError where it may not be read."""

    def sub(self, folder: str) -> Tree:
        """Return the view of a folder."""


@dataclass
class MemoryTree:
    """A tree of a plain dict; a str is the text of a file."""

    content: dict[str, TreeEntry]

    @classmethod
    def of(cls, files: Mapping[str, str | bytes | TreeEntry]) -> MemoryTree:
        return cls({path: to_entry(value) for path, value in files.items()})

    def files(self) -> Mapping[str, Kind]:
        return {path: entry.kind for path, entry in self.content.items()}

    def entry(self, path: str) -> TreeEntry:
        found = self.content.get(path)
        if found is None or found.kind not in FILES:
            raise FileNotFoundError(path)
        return found

    def sub(self, folder: str) -> MemoryTree:
        if not folder:
            return self
        prefix = folder + "/"
        return MemoryTree({p[len(prefix) :]: e for p, e in self.content.items() if p.startswith(prefix)})


def to_entry(value: str | bytes | TreeEntry) -> TreeEntry:
    if isinstance(value, TreeEntry):
        return value
    if isinstance(value, bytes):
        return TreeEntry("file", value)
    return TreeEntry("file", value.encode(), 0o755 if value.startswith("#!") else 0o644)

"""A folder on disk as a tree: files, symlinks, FIFOs and other things that a working tree holds."""

from __future__ import annotations

import os
import stat
from collections.abc import Iterator, Mapping, Sequence
from functools import cached_property
from pathlib import Path

from .disk_trace import MAX_BYTES, kind_of, link_target, read_limited, scan
from .fence import Fence
from .leftovers import is_build_output, is_made_package, is_never_source
from .light_dataclasses import dataclass, field
from .tree import Kind, SkippedError, TreeEntry


@dataclass
class DiskTree:
    """A folder on disk. Nothing is read before it is asked for, and nothing is read twice."""

    root: Path
    packages: Sequence[str] = ()
    """Folders of packages below the root, each with a fence of its own: one may be a link to another disk."""
    _entries: dict[str, TreeEntry] = field(default_factory=dict, init=False, repr=False)

    @cached_property
    def _files(self) -> dict[str, Kind]:
        return dict(sorted(walk(self.root, self.fence)))

    @cached_property
    def fence(self) -> Fence:
        return Fence(self.root, self.packages)

    def files(self) -> Mapping[str, Kind]:
        return self._files

    def entry(self, path: str) -> TreeEntry:
        if path not in self._entries:
            self._entries[path] = self.read(path)
        return self._entries[path]

    def read(self, path: str) -> TreeEntry:
        """Read one file; raises OSError, SkippedError where a link leads too far."""
        is_plain = "_files" in self.__dict__ and self._files.get(path) == "file"
        if not is_plain:
            self.fence.check(path)
        return read_entry(self.place(path), is_plain=is_plain)

    def place(self, path: str) -> str:
        """Return where a file of the tree lies: the root and the path, by which the trace knows it."""
        return f"{self._base}{path}"

    @cached_property
    def _base(self) -> str:
        return str(self.root / "x")[:-1]

    def sub(self, folder: str) -> DiskTree:
        return DiskTree(self.root / folder) if folder else self


def read_entry(path: str | Path, *, is_plain: bool = False) -> TreeEntry:
    """Read one regular file; raises OSError. One that is larger than MAX_BYTES comes without its bytes.

    `is_plain` says that a listing of its folder showed that it is no link.
    """
    found, data = read_limited(path)
    kind: Kind = "file" if is_plain or link_target(path) is None else "link"
    mode = stat.S_IMODE(found.st_mode)
    if data is None:
        size = f"{found.st_size / 1_000_000:.1f} MB"
        limit = f"{MAX_BYTES // 1_000_000} MB"
        return TreeEntry(
            kind, b"", mode, f"`{Path(path).name}` is not read: it has {size}, more than the limit of {limit}"
        )
    return TreeEntry(kind, data, mode)


def walk(root: Path, fence: Fence) -> Iterator[tuple[str, Kind]]:
    """Yield everything below a folder; build output and symlinks to folders are not entered.

    Without recursion, so that any depth is possible; a folder that can't be listed is left out.
    """
    waiting = [""]
    while waiting:
        prefix = waiting.pop()
        try:
            found = scan(os.path.join(root, prefix))  # noqa: PTH118
        except OSError:
            continue
        entries = [entry for entry in found if not is_never_source(entry.name)]
        names = {entry.name for entry in entries}
        if prefix and (is_build_output(prefix, names) or is_made_package(prefix, names)):
            continue
        if not entries and prefix:
            yield prefix.rstrip("/"), "dir"
        for entry in entries:
            if entry.is_dir(follow_symlinks=False):
                waiting.append(f"{prefix}{entry.name}/")
            else:
                yield prefix + entry.name, kind_in_tree(entry, prefix + entry.name, fence)


def kind_in_tree(entry: os.DirEntry[str], path: str, fence: Fence) -> Kind:
    """Return the kind of a directory entry that is not a folder."""
    if entry.is_file(follow_symlinks=False):
        return "file"
    try:
        if entry.is_dir():
            inner = os.path.join(entry.path, "__init__.py")  # noqa: PTH118
            return "linked-package" if kind_of(inner) == "f" else "linked-dir"
        if not entry.is_symlink() or not entry.is_file():
            return "other"
        fence.check(path)
    except SkippedError:
        return "outside"
    except OSError:
        return "other"
    return "link"

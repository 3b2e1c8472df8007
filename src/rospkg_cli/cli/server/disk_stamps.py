"""What changed on disk between two runs, for editors that do not tell."""

from __future__ import annotations

import os
from collections.abc import Sequence
from contextlib import suppress
from pathlib import Path

from ...disk import walk
from ...fence import Fence
from ...light_dataclasses import dataclass, field
from ...tree import FILES

Stamp = tuple[int, int, int]
"""The size of a file, when it was written (in ns), and its mode."""


@dataclass
class DiskStamps:
    """The files of a workspace as they were at the last look."""

    root: Path
    stamps: dict[str, Stamp] = field(default_factory=dict)

    def changed(self, packages: Sequence[str]) -> set[str]:
        """Return the files (from the root) that are new, gone, or not what they were at the last look."""
        before, now = self.stamps, self.look(packages)
        self.stamps = now
        return {path for path in before.keys() | now.keys() if before.get(path) != now.get(path)}

    def look(self, packages: Sequence[str]) -> dict[str, Stamp]:
        found = {}
        for path, kind in walk(self.root, Fence(self.root, packages)):
            if kind in FILES:
                with suppress(OSError):
                    at = os.stat(f"{self.root}/{path}")  # noqa: PTH116  # thousands of them
                    found[path] = (at.st_size, at.st_mtime_ns, at.st_mode)
        return found

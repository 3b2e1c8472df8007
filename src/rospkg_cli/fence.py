"""Where symlinks may lead: into the package or its repository; nothing outside is read or written."""

from __future__ import annotations

import os
from collections.abc import Iterable
from functools import cached_property
from pathlib import Path

from .disk_trace import is_there, link_target, real_path
from .light_dataclasses import dataclass
from .tree import LeadsOutError

SHARED = frozenset(map(Path, "/ /home /opt /root /srv /tmp /usr /usr/local /var".split()))
"""Folders that hold everybody's files: never a workspace, a repository, or the parent of a student's packages."""


@dataclass
class Fence:
    """What may be read of the tree below `root`; `packages` are folders of it that may themselves be links."""

    root: Path
    packages: Iterable[str] = ()

    def check(self, path: str) -> str:
        """Return the real path; raises LeadsOutError where that is outside of its package and repository."""
        real = real_path(self.root / path)
        if any(is_within(real, each) for each in self.allowed(path)):
            return real
        target = self.target(path)
        raise LeadsOutError(f"`{path}` is a link to `{target}`, out of the package and its repository: it is not read")

    def target(self, path: str) -> str:
        """Return where the first link of a path points, as the link says it."""
        parts = path.split("/")
        for end in range(1, len(parts) + 1):
            place = self.root.joinpath(*parts[:end])
            if (target := link_target(place)) is not None:
                return target
        return path

    def allowed(self, path: str) -> tuple[str, ...]:
        """Return the folders that a path may lead into: those of the innermost package that it lies in."""
        while path and path not in self._packages:
            path = path.rpartition("/")[0]
        if path not in self._allowed:
            real = real_path(self.root / path)
            repository = repository_of(Path(real))
            self._allowed[path] = (real, str(repository)) if repository else (real,)
        return self._allowed[path]

    @cached_property
    def _packages(self) -> frozenset[str]:
        return frozenset(self.packages)

    @cached_property
    def _allowed(self) -> dict[str, tuple[str, ...]]:
        return {}


def is_within(path: str, folder: str) -> bool:
    return path == folder or path.startswith(folder.rstrip(os.sep) + os.sep)


def repository_of(folder: Path) -> Path | None:
    """Return the root of the git repository that a folder lies in; a home or another shared folder does not count."""
    for each in (folder, *folder.parents):
        if is_shared(each):
            return None
        if is_there(each / ".git"):
            return each
    return None


def is_shared(folder: Path) -> bool:
    """Return whether a folder is the root, a home, the folder for temporary files or the like."""
    own = [value for name in ("HOME", "USERPROFILE", "TMPDIR", "TEMP") if (value := os.environ.get(name))]
    return folder in SHARED or str(folder) in map(os.path.normpath, own) or folder == folder.parent

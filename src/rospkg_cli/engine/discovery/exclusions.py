"""`exclude` of the configs: patterns as gitignore has them, and those that fit nothing."""

from __future__ import annotations

from collections.abc import Iterator
from fnmatch import fnmatch
from pathlib import Path

from ...config.file import Config
from ...config.hierarchy import ConfigTree
from ...disk_trace import is_folder, scan
from ...leftovers import is_never_source

MAX_FOLDERS = 2_000
"""Looked through for something that a pattern fits; in a larger tree none is called unused."""


class Exclusions:
    """Answers which packages are left out, and remembers which patterns left one out."""

    def __init__(self, configs: ConfigTree) -> None:
        self.configs = configs
        self.used: set[tuple[Path | None, str]] = set()

    def leave_out(self, path: Path) -> bool:
        """Return whether a config at or above a folder excludes it."""
        for config in self.configs.above(path):
            for pattern in config.exclude:
                if path.is_relative_to(config.folder) and fits(path.relative_to(config.folder).parts, pattern):
                    self.used.add((config.path, pattern))
                    return True
        return False

    def unused(self, config: Config) -> Iterator[str]:
        """Yield the patterns of a config that left nothing out, and that nothing below its folder has the name of."""
        for pattern in config.exclude:
            if (config.path, pattern) not in self.used and not is_anywhere(config.folder, pattern):
                yield pattern


def fits(parts: tuple[str, ...], pattern: str) -> bool:
    """Return whether a pattern fits a path or a folder above it; without a slash, in any depth."""
    wanted = pattern.rstrip("/")
    if "/" not in wanted:
        return any(fnmatch(part, wanted) for part in parts)
    wanted = wanted.removeprefix("./").lstrip("/")
    return any(fnmatch("/".join(parts[:n]), wanted) for n in range(1, len(parts) + 1))


def is_anywhere(folder: Path, pattern: str) -> bool:
    """Return whether a pattern fits something below a folder, as far as that can be decided at a moderate cost."""
    waiting, looked = [folder], 0
    while waiting:
        here, looked = waiting.pop(0), looked + 1
        if looked > MAX_FOLDERS:
            return True
        try:
            names = [entry.name for entry in scan(here) if not is_never_source(entry.name)]
        except OSError:
            continue
        if any(fits((here / name).relative_to(folder).parts, pattern) for name in names):
            return True
        waiting += [here / name for name in names if is_folder(here / name)]
    return False

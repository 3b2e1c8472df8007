"""Several configs in one run: the root's, and for each package the nearest at or above its folder."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

from ..current_folder import absolute
from .file import Config, config_files, load_config


class ConfigTree:
    """The configs of a run, each read when it is first asked for.

    The root's alone says which plugins, targets, version and level of failing hold; rules, levels and ignores of a
    package come from the nearest one. Raises ConfigError where one is wrong.
    """

    def __init__(self, root: Config, is_only: bool = False) -> None:
        self.root = root
        self.is_only = is_only
        """Whether no other config counts: with --config and --isolated."""
        self.read: dict[Path, Config | None] = {root.folder: root} if root.path else {}

    def in_folder(self, folder: Path) -> Config | None:
        """Return the config that lies in a folder."""
        if folder not in self.read:
            self.read[folder] = next((load_config(*found) for found in config_files(folder)), None)
        return self.read[folder]

    def above(self, folder: Path) -> Iterator[Config]:
        """Yield the configs at and above a folder, the nearest first and the root's last."""
        if not self.is_only:
            for each in (folder, *folder.parents):
                if self.root.path and each == self.root.folder:
                    break
                if found := self.in_folder(each):
                    yield found
        yield self.root

    def at(self, folder: Path) -> Config:
        """Return the nearest config at or above a folder."""
        return next(self.above(folder))


def root_config(folder: Path, top: Path | None) -> Config:
    """Return the config of a run: the outermost from the workspace down to a folder, else the nearest above them."""
    inside = [each for each in (folder, *folder.parents) if top is not None and each.is_relative_to(top)]
    outside = [each for each in (folder, *folder.parents) if each not in inside]
    for each in (*reversed(inside), *outside):
        for path, table in config_files(each):
            return load_config(path, table)
    return Config()


def named_config(path: Path) -> Config:
    """Return the config of a file that --config names; raises ConfigError."""
    path = absolute(path)
    return load_config(path, ("tool", "rospkg") if path.name == "pyproject.toml" else ())


NO_CONFIGS = ConfigTree(Config(), is_only=True)

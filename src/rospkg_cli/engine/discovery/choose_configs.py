"""Which configs hold for the paths of a run."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from ...config.file import Config
from ...config.hierarchy import ConfigTree, named_config, root_config
from ...current_folder import absolute, common_folder
from .locate import workspace_of


def choose_configs(paths: Sequence[Path], named: Path | None = None, isolated: bool = False) -> ConfigTree:
    """Return the configs for some paths: the one that is named, none where isolated, else those that lie around them.

    Raises ConfigError where the root's is wrong.
    """
    if isolated:
        return ConfigTree(Config(), is_only=True)
    if named is not None:
        return ConfigTree(named_config(named), is_only=True)
    folder = absolute(common_folder(paths))
    return ConfigTree(root_config(folder, workspace_of([folder])))

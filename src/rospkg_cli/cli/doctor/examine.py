"""What `rospkg doctor` examines, in the order in which it is shown."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from pathlib import Path

from ...config.file import ConfigError
from ...config.hierarchy import ConfigTree
from ...engine.discovery.choose_configs import choose_configs
from ...engine.discovery.locate import locate
from .configs import broken_config, configs_in_force
from .machine import cache, program, ros
from .names import index, targets
from .plugins import plugins
from .topic import Topic
from .workspace import packages, switched_off, workspace


def examine(paths: Sequence[Path]) -> Iterator[Topic]:
    """Yield the topics; a config that is wrong is one of them, and counts as none for the rest."""
    yield program()
    wrong = ""
    try:
        configs = choose_configs(paths)
        located = locate(paths, None, configs)
        shown = configs_in_force(configs, located)
    except ConfigError as error:
        wrong, configs = str(error), choose_configs(paths, isolated=True)
        located = locate(paths, None, configs)
        shown = broken_config(wrong)
    yield shown
    yield workspace(paths, located)
    yield packages(paths, located)
    names, known = index()
    yield names
    yield switched_off(located, known)
    yield from of_config(configs, located.root)
    yield ros(located.scope.prefix_names)
    yield cache()


def of_config(configs: ConfigTree, root: Path) -> Iterator[Topic]:
    yield targets(configs.root)
    yield plugins(configs.root, root)

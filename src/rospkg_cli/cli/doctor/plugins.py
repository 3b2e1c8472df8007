"""The plugins that the config names, and those that are installed."""

from __future__ import annotations

from importlib.metadata import entry_points
from pathlib import Path

from ...config.file import Config
from ...engine.run.rule_plugins import GROUP, PluginError, load_plugins
from .topic import Topic


def plugins(config: Config, root: Path) -> Topic:
    """Return which plugins are used and which are installed without being named; one that fails is wrong."""
    installed = sorted({point.name for point in entry_points(group=GROUP)})
    data = {"used": list(config.plugins), "installed": installed}
    try:
        load_plugins(config.plugins, root, config.folder)
    except PluginError as error:
        return Topic("plugins", (str(error),), data, is_wrong=True)
    unused = [name for name in installed if name not in config.plugins]
    line = ", ".join(config.plugins) or "none"
    rest = f"installed and not used: {', '.join(unused)}; `plugins` of the config names them" if unused else ""
    return Topic("plugins", (line,), data, rest)

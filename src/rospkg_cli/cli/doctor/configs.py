"""Which configs are in force, and where they come from."""

from __future__ import annotations

from ...config.file import user_config, user_config_path
from ...config.hierarchy import ConfigTree
from ...disk_trace import is_file
from ...engine.discovery.locate import Located
from ...report.summary import counted
from .topic import Topic


def configs_in_force(configs: ConfigTree, located: Located) -> Topic:
    """Return the root's config, and those of packages below it, with the number of packages of each.

    Raises ConfigError where one is wrong, the user's own too.
    """
    found = {configs.root.path: 0}
    for folder in sorted(located.scope.selected):
        path = configs.at(located.root / folder).path
        found[path] = found.get(path, 0) + 1
    lines = [
        f"{path or 'none: defaults'} ({'for the run, ' if path == configs.root.path else ''}{counted(n, 'package')})"
        for path, n in found.items()
    ]
    own = user_config_path() if is_file(user_config_path()) else None
    user_config()
    lines += [f"{own} (yours)"] if own else []
    data = {
        "files": [{"path": str(path) if path else None, "packages": n} for path, n in found.items()],
        "user": str(own) if own else None,
    }
    return Topic("config", tuple(lines), data)


def broken_config(error: str) -> Topic:
    return Topic("config", (error,), {}, "lint stops at this; repair the file, or run with --isolated", is_wrong=True)

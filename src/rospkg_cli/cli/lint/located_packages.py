"""The packages that the paths of `rospkg lint` mean, or those of them that git sees a change in."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from ...config.hierarchy import ConfigTree
from ...disk_trace import exists
from ...engine.discovery.locate import Located, locate
from ...engine.selection import codes_named
from ...light_dataclasses import replace
from .. import UsageError
from .lint_options import LintOptions


def located_packages(paths: Sequence[Path], options: LintOptions, configs: ConfigTree) -> Located:
    """Find the packages; raises LocateError, and UsageError for a rule that stands where a path belongs."""
    for path in paths:
        if not exists(path) and codes_named(str(path)):
            raise UsageError(f"`{path}` is a rule, and stands where a path belongs; join rules by commas: --select A,B")
    located = locate(paths, options.workspace, configs)
    return changed_alone(located, options.since or "") if options.changed or options.since is not None else located


def changed_alone(located: Located, since: str) -> Located:
    """Return the packages without those that git sees no change in; raises GitError."""
    from .changed_packages import changed_packages

    folders = {located.root / folder: folder for folder in located.scope.selected}
    changed = changed_packages(sorted(folders), since)
    selected = frozenset(folder for path, folder in folders.items() if path in changed)
    return replace(located, scope=replace(located.scope, selected=selected))

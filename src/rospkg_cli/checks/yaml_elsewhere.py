"""Whether anything may give a YAML file of a package to a node: the package itself, or another one."""

from __future__ import annotations

import posixpath
from collections.abc import Iterable

from ..package.package_facts import PackageFacts
from ..package.params.named_yaml import ANY
from ..package.workspace import Workspace


def is_named_yaml(path: str, package: PackageFacts, workspace: Workspace) -> bool:
    """Return whether anything in the workspace names a YAML file of a package, or may."""
    stem = posixpath.splitext(posixpath.basename(path))[0]
    named = package.named_yaml
    return stem in named or ANY in named or is_named_elsewhere(stem, package, workspace)


def is_of_another(places: Iterable[str], package: PackageFacts, workspace: Workspace) -> bool:
    """Return whether launch files give nodes a file of these paths of other packages, and never that of this one.

    A copy of a package keeps its files, and its launch files still name the first package.
    """
    owners = {each.name for place in places for each in workspace.packages if is_handed(each.name, place, workspace)}
    return bool(owners) and package.name not in owners


def is_handed(package: str, place: str, workspace: Workspace) -> bool:
    return bool(workspace.having("handed_yaml", package, place))


def is_named_elsewhere(stem: str, package: PackageFacts, workspace: Workspace) -> bool:
    """Return whether another package may name a file: it needs this one and names the file, or puts names together,
    or it names a file that it does not have itself.
    """
    ends = (f"/{stem}.yaml", f"/{stem}.yml")
    needing = {facts.name for facts in workspace.needing(package.name)}
    for facts in (each for each in workspace.packages if each.name != package.name):
        if facts.name in needing and not facts.named_yaml.isdisjoint((stem, ANY)):
            return True
        files = (*facts.share_files, *facts.uninstalled) if stem in facts.named_yaml else ends
        if not any(f"/{path}".endswith(ends) for path in files):
            return True
    return False

"""Packages that may come from a fork, which may have kept what no distribution has any more."""

from __future__ import annotations

from ...package.package_facts import PackageFacts
from ...package.workspace import Workspace
from ...ros.names import NameKind
from ...ros.well_known import removed

FORMER = ("programs", "components", "plugins")
KNOWN = (NameKind.PACKAGE, NameKind.KEY)


def is_of_fork(package: str, user: PackageFacts, workspace: Workspace) -> bool:
    """Return whether a dependency of the user has the same prefix as a package and is in no distribution, old or new.

    For `velodyne_pointcloud` that is `velodyne_monitor`, which only a fork of its repository has.
    """
    family = package.partition("_")[0]
    sisters = {each.name for each in user.dependencies if each.name.partition("_")[0] == family} - {package}
    former = {name for kind in FORMER for name in removed(kind)}
    return any(workspace.kind_of(name) not in KNOWN and workspace.named(name) is None for name in sisters - former)

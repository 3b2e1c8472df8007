"""Milder findings in a package that catkin builds as well, in a repository whose other packages are all for ROS 1."""

from __future__ import annotations

from ...finding import Finding
from ...package.workspace import Workspace
from .fitting_rules import OF_ROS_2
from .milder import RuleResults, as_infos

LEAST = 2
"""How many other packages say so: a single one may be what is left of a port."""
WHY = "; all other packages here are for ROS 1, and catkin builds this one too"


def with_ros1_neighbours(results: RuleResults, name: str, workspace: Workspace) -> RuleResults:
    """Return the results of a package, with infos for what only builds and runs of ROS 2 would show.

    Such a package was copied with conditions for both versions (`$ROS_VERSION == 2`, REP 149), and declares catkin
    without one.
    """
    own = workspace.named(name)
    if own is None or not any(each.name == "catkin" and each.tag == "buildtool_depend" for each in own.dependencies):
        return results
    others = [each for each in workspace.packages if each.folder != own.folder]
    if len(others) < LEAST or not all(each.is_for_ros1 for each in others):
        return results
    codes = frozenset(each.code for each in results if isinstance(each, Finding) and each.code.startswith(OF_ROS_2))
    return as_infos(results, codes, lambda _: WHY)

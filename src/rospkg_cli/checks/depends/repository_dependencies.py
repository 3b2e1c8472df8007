"""What the other packages of a repository declare: whoever builds the whole repository has it installed."""

from __future__ import annotations

import posixpath
from collections.abc import Iterator, Mapping

from ...package.package_facts import PackageFacts
from ...package.workspace import Workspace
from .brought_dependencies import brought_by

NO_INSTALL = "doc_depend"
"""`rosdep install` ignores it."""


def is_declared_by_others(name: str, own: PackageFacts, here: frozenset[str] | None, workspace: Workspace) -> bool:
    """Return whether another package of a repository declares a dependency.

    `here` are the folders of its packages; None, where repositories are unknown, stands for the whole workspace.
    """
    others = (facts for facts in workspace.needing(name) if facts.folder != own.folder and is_in(here, facts))
    return any(name in needs_of(facts) for facts in others)


def brought_in(here: frozenset[str] | None, workspace: Workspace) -> Mapping[str, str]:
    """Return what comes with the dependencies of all packages of a repository, each with the one that brings it."""
    known = workspace.index_of(BroughtIn)
    if here not in known:
        needs = (name for facts in workspace.packages if is_in(here, facts) for name in needs_of(facts))
        known[here] = brought_by(dict.fromkeys(needs), workspace)
    return known[here]


class BroughtIn(dict["frozenset[str] | None", Mapping[str, str]]):
    """What comes with all packages of a repository, by the folders of these packages."""


def is_in(here: frozenset[str] | None, facts: PackageFacts) -> bool:
    return (here is None or facts.folder in here) and not facts.is_for_ros1


def needs_of(facts: PackageFacts) -> Iterator[str]:
    """Yield what rosdep installs for a package under any condition."""
    return (need.name for need in facts.dependencies if need.certain and need.tag != NO_INSTALL)


def repository_of(folder: str, workspace: Workspace) -> str:
    """Return the beginning of all paths in the repository of a folder; "" where the run has no other repository."""
    here = next((each for each in workspace.repositories if folder in each), frozenset[str]())
    others = [each for one in workspace.repositories if one is not here for each in one]
    if not here or not others:
        return ""
    start = posixpath.commonpath(here)
    while start and not any(f"{each}/".startswith(above_of(start)) for each in others):
        start = posixpath.dirname(start)
    return f"{start}/" if start else ""


def above_of(folder: str) -> str:
    """Return the beginning of all paths next to a folder: `src/` for `src/my_pkg`."""
    return f"{posixpath.dirname(folder)}/".lstrip("/")

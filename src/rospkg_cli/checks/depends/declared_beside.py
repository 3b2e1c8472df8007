"""What the packages of one repository declare together: whoever builds all of them has it."""

from __future__ import annotations

import posixpath
from collections.abc import Iterator, Mapping

from ...package.package_facts import PackageFacts
from ...package.workspace import Workspace
from .brought_dependencies import brought_by

NO_INSTALL = "doc_depend"
"""`rosdep install` passes it over."""


def is_declared_by_others(name: str, own: PackageFacts, here: frozenset[str] | None, workspace: Workspace) -> bool:
    """Return whether another package of a repository, by its folders, declares a dependency.

    Where the repositories are not known (None), all of the workspace counts as one.
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
    """What comes with all packages of each repository, by their folders."""


def is_in(here: frozenset[str] | None, facts: PackageFacts) -> bool:
    return (here is None or facts.folder in here) and not facts.is_for_ros1


def needs_of(facts: PackageFacts) -> Iterator[str]:
    """Yield what rosdep installs for a package whatever the conditions."""
    return (need.name for need in facts.dependencies if need.certain and need.tag != NO_INSTALL)


def repository_of(folder: str, workspace: Workspace) -> str:
    """Return what all paths in the repository of a package begin with; "" where the run holds no other one."""
    here = next((each for each in workspace.repositories if folder in each), frozenset[str]())
    others = [each for one in workspace.repositories if one is not here for each in one]
    if not here or not others:
        return ""
    start = posixpath.commonpath(here)
    while start and not any(f"{each}/".startswith(above_of(start)) for each in others):
        start = posixpath.dirname(start)
    return f"{start}/" if start else ""


def above_of(folder: str) -> str:
    """Return what all paths beside a folder begin with."""
    return f"{posixpath.dirname(folder)}/".lstrip("/")

"""A place where a launch ends, as it looks for a package that nothing brings: no release, no listed repository."""

from __future__ import annotations

from ...light_dataclasses import dataclass
from ...package.launch.launch_file import LaunchFile
from ...package.workspace import Workspace
from ...ros.known_nodes import known_parameters
from ...ros.well_known import is_well_known
from ...source import Span
from .idle_actions import level_at


@dataclass(frozen=True, slots=True)
class UnmetLookup:
    package: str
    span: Span
    hidden: tuple[Span, ...]
    """The part that no launch reaches, as it ends here before."""
    is_early: bool = False
    """Whether Python raises there, as it reads the file or runs a function."""


def is_met(file: LaunchFile, span: Span) -> bool:
    """Return whether every launch reaches a place, if nothing ends it before."""
    return level_at(file, span)[0] is None


def is_brought_by_nothing(name: str, workspace: Workspace) -> bool:
    """Return whether no package of a name is here, released or well-known, and none may lie in a listed repository."""
    index = workspace.index
    is_known = index.is_package(name) or index.is_key(name) or bool(known_parameters(name)) or is_well_known(name)
    if is_known or workspace.is_available(name) or workspace.folder_of_project(name):
        return False
    return workspace.is_complete or (bool(workspace.missing_repositories) and not workspace.may_lack(name))

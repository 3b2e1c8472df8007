"""Which packages a run reads and reports on."""

from __future__ import annotations

from ...light_dataclasses import dataclass
from ...ros.names import BUILT_IN, Names


@dataclass(frozen=True)
class Scope:
    """The packages of a run, and what is known around them. Folders are relative to the root of the tree."""

    folders: tuple[str, ...]
    """Every package of the workspace."""
    selected: frozenset[str]
    """The packages to report on, as in Workspace."""
    name: str = "package"
    """The name of the root folder."""
    incomplete: str = ""
    """What says that packages of the workspace are not here; "" where nothing does."""
    prefix_names: frozenset[str] = frozenset()
    """As in Workspace; so are the following."""
    index: Names = BUILT_IN
    repositories: tuple[frozenset[str], ...] = ()
    missing_repositories: frozenset[str] = frozenset()
    cmake_projects: tuple[tuple[str, str], ...] = ()

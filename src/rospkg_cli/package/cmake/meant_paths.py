"""What paths that CMake names and that are not there stand for: a file or a folder of nearly that name."""

from __future__ import annotations

import posixpath
from collections.abc import Iterable

from ...suggest import nearest
from .cmake_project import CMake
from .referenced_paths import ReferencedPath, ReferencedPaths

LISTS = "/CMakeLists.txt"


def meant_path(cmake: CMake, named: ReferencedPath) -> str | None:
    """Return the one path that is intended; of a folder one beside it."""
    paths = cmake.package_files.paths
    if named.use == "subdirectory":
        folders = (path.removesuffix(LISTS) for path in paths if path.endswith(LISTS))
        folder = nearest(named.path.removesuffix(LISTS), folders)
        return None if folder is None else folder + LISTS
    return nearest(named.path, folders_beside(named, paths) if named.use in ("folder", "matching") else paths)


def folders_beside(named: ReferencedPath, paths: Iterable[str]) -> Iterable[str]:
    start = f"{parent}/" if (parent := posixpath.dirname(named.path)) else ""
    inside = (path.removeprefix(start).partition("/") for path in paths if path.startswith(start))
    return {f"{start}{name}" for name, slash, _ in inside if slash}


def meant_paths(cmake: CMake) -> frozenset[str]:
    """Return all paths that others stand for, which are told: nobody is to miss them besides."""
    known: dict[str, frozenset[str]] = vars(cmake).setdefault("paths_known", {})
    if "meant" not in known:  # several rules ask
        sure = (each for each in ReferencedPaths(cmake).missing() if not (each.call.maybe or each.word.maybe))
        known["meant"] = frozenset(filter(None, (meant_path(cmake, each) for each in sure)))
    return known["meant"]

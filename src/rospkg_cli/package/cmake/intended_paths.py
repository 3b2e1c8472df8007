"""Which paths are intended where CMake names one that does not exist: a file or a folder of nearly that name."""

from __future__ import annotations

import posixpath
from collections.abc import Iterable

from ...suggest import nearest
from .cmake_project import CMake
from .referenced_paths import ReferencedPath, ReferencedPaths

LISTS = "/CMakeLists.txt"


def intended_path(cmake: CMake, named: ReferencedPath) -> str | None:
    """Return the one path that is intended; of a folder one in the same parent."""
    paths = cmake.package_files.paths
    if named.use == "subdirectory":
        folders = (path.removesuffix(LISTS) for path in paths if path.endswith(LISTS))
        folder = nearest(named.path.removesuffix(LISTS), folders)
        return None if folder is None else folder + LISTS
    return nearest(named.path, sibling_folders(named, paths) if named.use in ("folder", "matching") else paths)


def sibling_folders(named: ReferencedPath, paths: Iterable[str]) -> Iterable[str]:
    """Return the folders with the same parent as a path."""
    start = f"{parent}/" if (parent := posixpath.dirname(named.path)) else ""
    inside = (path.removeprefix(start).partition("/") for path in paths if path.startswith(start))
    return {f"{start}{name}" for name, slash, _ in inside if slash}


def intended_paths(cmake: CMake) -> frozenset[str]:
    """Return the intended paths of all that are missing: a check reports these, so that others need not."""
    known: dict[str, frozenset[str]] = vars(cmake).setdefault("paths_known", {})
    if "intended" not in known:  # several rules ask
        sure = (each for each in ReferencedPaths(cmake).missing() if not (each.call.maybe or each.word.maybe))
        known["intended"] = frozenset(filter(None, (intended_path(cmake, each) for each in sure)))
    return known["intended"]

"""What paths that CMake names and that are not there stand for: a file or a folder of nearly that name."""

from __future__ import annotations

import posixpath
from collections.abc import Iterable

from ...suggest import nearest
from .cmake_project import CMake
from .referenced_paths import ReferencedPath, ReferencedPaths


def meant_path(cmake: CMake, named: ReferencedPath) -> str | None:
    """Return the one path that is intended; of a folder one beside it."""
    return nearest(named.path, candidates(cmake, named))


def candidates(cmake: CMake, named: ReferencedPath) -> Iterable[str]:
    paths = cmake.package_files.paths
    if named.use == "subdirectory":
        return (path for path in paths if path.endswith("/CMakeLists.txt"))
    if named.use != "folder":
        return paths
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

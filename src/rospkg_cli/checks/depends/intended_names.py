"""What is intended by a declared name that is wrong and that another rule reports: DEP001, or DEP203."""

from __future__ import annotations

from ...package.workspace import Workspace
from ...ros.aliases import NOTHING_NEEDED, key_for_pip, keys_for_cmake, successors
from ...ros.names import NameKind
from .similar_names import SimilarNames

PYTHON_2, PYTHON_3 = "python-", "python3-"
VERSION = "0123456789.-_"
"""Characters at the end of a name that are a version: `gz-plugin3` is no misspelt `gz-plugin2`."""

KNOWN = (NameKind.PACKAGE, NameKind.KEY)


def intended_names(name: str, workspace: Workspace) -> tuple[str, ...]:
    """Return the names to write instead of one: the name itself where it is right, or where nothing is near.

    Several stand in one tag, or a package of ROS 1 was split.
    """
    if workspace.is_available(name) or workspace.folder_of_project(name):
        return (name,)
    if taken := successors(name):
        return taken
    if name.startswith(PYTHON_2) and workspace.index.is_key(key := PYTHON_3 + name.removeprefix(PYTHON_2)):
        return (key,)
    if workspace.kind_of(name) in KNOWN:
        return (name,)
    parts = name.replace(",", " ").split()
    if len(parts) > 1:
        return tuple(parts)
    if found := key_of_cmake_name(name):
        return (found,)
    intended = key_for_pip(name, workspace.index) or SimilarNames(workspace).intended(name) or name
    return (intended,) if intended.rstrip(VERSION) != name.rstrip(VERSION) else (name,)


def key_of_cmake_name(name: str) -> str | None:
    """Return the key of what CMake calls by a name: `eigen` of Eigen3; None for a name that is in lower case."""
    keys = [each for each in keys_for_cmake(name) if each != NOTHING_NEEDED and "*" not in each]
    return keys[0] if keys and not name.islower() else None

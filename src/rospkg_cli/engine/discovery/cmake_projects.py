"""Plain CMake projects: folders without a package.xml that colcon builds by the name in their `project()`."""

from __future__ import annotations

import os
import re
from collections.abc import Callable, Iterable
from pathlib import Path

from ...disk_trace import read_limited
from ...lazy_regex import regex
from ...tree import Tree

LIST = "CMakeLists.txt"
PROJECT = regex(rb"^[ \t]*project[ \t]*\(\s*\"?([\w.+-]+)[\s\")]", re.MULTILINE | re.IGNORECASE)
OF_ROS = regex(rb"\b(?:ament|catkin)(?:_\w+)?\b")
"""A project that uses these has a package.xml, or is given one before the build: it is none of plain CMake."""
MAX_READ = 200
"""Files that are read: a large library that was copied in has thousands, and colcon looks into no project."""


def cmake_projects(
    folders: Iterable[Path], packages: Iterable[Path], root: Path, read: Callable[[Path], bytes]
) -> tuple[tuple[str, str], ...]:
    """Return the name and the folder, relative to the root, of each plain project among folders with a CMakeLists.txt.

    One in another is part of it, and one that holds packages is left aside.
    """
    above = {folder for package in packages for folder in (package, *package.parents)}
    found: dict[str, Path] = {}
    last: Path | None = None
    for folder in [each for each in sorted(set(folders)) if each not in above][:MAX_READ]:
        is_part = last is not None and folder.is_relative_to(last)
        text = b"" if is_part else read(folder / LIST)
        if named := PROJECT.search(text):
            last = folder
        if named and not OF_ROS.search(text):
            found.setdefault(named[1].decode("utf-8", "replace"), folder)
    return tuple((name, Path(os.path.relpath(found[name], root)).as_posix()) for name in sorted(found))


def read_list(path: Path) -> bytes:
    """Return what a CMakeLists.txt holds; nothing where it can't be read."""
    try:
        return read_limited(path)[1] or b""
    except OSError:
        return b""


def cmake_projects_in(tree: Tree, packages: Iterable[str]) -> tuple[tuple[str, str], ...]:
    """Return the plain projects of a tree in memory."""
    top = Path("/")
    within = [top / each for each in packages]
    lists = [top / path for path in tree.files() if path.rpartition("/")[2] == LIST]
    folders = [each.parent for each in lists if not any(each.is_relative_to(package) for package in within)]
    return cmake_projects(folders, within, top, lambda path: tree.entry(path.relative_to(top).as_posix()).data)

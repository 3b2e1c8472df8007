"""What tools leave in a working tree that is not source: builds, environments, caches, temporary files."""

from __future__ import annotations

import re
from collections.abc import Set

from .lazy_regex import regex

SKIPPED = frozenset(
    ".git .hg .svn .venv venv node_modules __pycache__ .tox .nox .eggs .mypy_cache .pytest_cache .ruff_cache".split()
)
"""Folders that are never part of a package's source."""

MARKER_FILES = frozenset({"pyvenv.cfg", "CMakeCache.txt", "CACHEDIR.TAG", "colcon_build.rc"})
"""A folder that holds one of them is a virtual environment, CMake's or colcon's build folder, or a cache, under any
name."""

BUILD_FOLDERS = {
    "build": regex(r"COLCON_IGNORE|\.built_by|(bdist|lib|temp)\..+"),
    "install": regex(r"COLCON_IGNORE|\.colcon_install_layout|local_setup\.(ba|z)?sh|local_setup\.(ps1|bat)"),
    "log": regex(r"COLCON_IGNORE|latest(_\w+)?|(build|test|list)_\d{4}-\d\d-\d\d_.*"),
}
"""Output folders of colcon and setuptools, with names in them that mark one as output."""

MADE_BY_COLCON = frozenset({"colcon_build.rc", "prefix_override"})
"""What colcon writes into the build folder of a package, in addition to the files that it links there."""

MADE_BESIDE = regex(r"(?:local_setup|package)\.(?:bash|dsv|ps1|sh|zsh)|hook|environment|ament_index")
"""What a build installs next to package.xml, in `share/<package>`."""

STRAY = regex(r"\.(?P<name>.+)\.(?P<process>\d+)-\w+\.rospkg-tmp", re.DOTALL)
"""A file of ours that was being written when the process was killed."""

NEVER_SOURCE = regex(rf"\._.*|{STRAY.pattern}", re.DOTALL)
"""Resource forks of macOS (`._setup.py` is not Python), and our own temporary files."""


def is_never_source(name: str) -> bool:
    """Return whether a file or folder is never part of a package's source, by its name alone."""
    return name in SKIPPED or (name[:1] == "." and NEVER_SOURCE.fullmatch(name) is not None)


def is_build_output(folder: str, names: Set[str]) -> bool:
    """Return whether a folder with these names in it is output of a build, or a virtual environment."""
    if not MARKER_FILES.isdisjoint(names):
        return True
    marks = BUILD_FOLDERS.get(folder.rstrip("/").rpartition("/")[2])
    return marks is not None and any(marks.fullmatch(name) for name in names)


def is_made_package(folder: str, names: Set[str]) -> bool:
    """Return whether a folder with a package.xml is what a build made of a package: installed, or linked by colcon."""
    if "package.xml" not in names:
        return False
    if not names.isdisjoint(MADE_BY_COLCON):
        return True
    above = folder.rstrip("/").split("/")[:-1]
    if above[-1:] != ["share"] or not names.isdisjoint({"CMakeLists.txt", "setup.py"}):
        return False
    return "install" in above or {"opt", "ros"} <= set(above) or any(MADE_BESIDE.fullmatch(name) for name in names)

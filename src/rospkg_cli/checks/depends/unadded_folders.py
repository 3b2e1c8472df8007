"""Files below a CMakeLists.txt that no other one adds: nothing of the package's build reads it, and compiles them."""

from __future__ import annotations

import posixpath
import re
from collections.abc import Iterable

from ...files import PackageFiles
from ...lazy_regex import regex
from ...package.cmake.cmake_project import CMake
from ...package.launch.live_text import live_text
from ..repository.pages_and_scripts import pages_and_scripts

ROOT = "CMakeLists.txt"
ADDS = regex(r"(?i)\b(?:add_subdirectory|subdirs|externalproject_add|fetchcontent_\w+|ament_vendor)\s*\(([^)]*)\)")


def files_nothing_adds(files: PackageFiles, cmake: CMake, paths: Iterable[str]) -> frozenset[str]:
    """Return those of some paths that lie in folders with a CMakeLists.txt which nothing here is shown to run."""
    read = {file.path for file in cmake.files}
    lists = (path for path in files.paths if posixpath.basename(path) == ROOT and path not in read)
    folders = tuple(f"{posixpath.dirname(path)}/" for path in lists if "/" in path)
    left = tuple(each for each in folders if not is_added(files, each) and not is_built_alone(files, each))
    return frozenset(path for path in paths if path.startswith(left)) if left else frozenset()


def is_added(files: PackageFiles, folder: str) -> bool:
    """Return whether a CMake file outside of a folder adds it, by a name that is computed perhaps."""
    word = named(folder)
    others = (path for path in files.paths if path.endswith((ROOT, ".cmake")) and not path.startswith(folder))
    added = (text for path in others for text in ADDS.findall(live_text(files, path)))
    return any("$" in text.replace("${CMAKE_CURRENT_SOURCE_DIR}", "") or word.search(text) for text in added)


def is_built_alone(files: PackageFiles, folder: str) -> bool:
    """Return whether a folder is a package, or a command of a page or a script goes to it."""
    goes = re.compile(rf"\b(?:cmake|make[ \t]+-C|cd|pushd|--(?:base-)?paths)\b[^\n]*?{named(folder).pattern}")
    return files.exists(f"{folder}package.xml") or any(map(goes.search, pages_and_scripts(files)))


def named(folder: str) -> re.Pattern[str]:
    return re.compile(rf"(?<![\w-]){re.escape(posixpath.basename(folder.rstrip('/')))}(?![\w-])")

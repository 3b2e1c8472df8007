"""Scripts that are installed only because a rule takes their whole folder, and that nothing starts (CMK105)."""

from __future__ import annotations

import posixpath
import re

from .broken_scripts import BrokenScript
from .installed_scripts import InstalledScripts
from .left_out_nodes import USES_ROS
from .module_imports import dotted_imports

COMMENT = r"^[ \t]*#[^\n]*(?<![\w.-])"
"""The start of a comment that goes on to a word."""


def comes_with_folder(scripts: InstalledScripts, script: BrokenScript) -> bool:
    """Return whether a script only came with its folder, or by a pattern (`file(GLOB …)`).

    It is imported, has no word of ROS, or a comment names it. What a launch file, a README or a rule names by itself
    is intended to be run.
    """
    path, cmake = script.copy.source, scripts.package.cmake
    is_globbed = "*" in cmake.source_text(script.copy.item)
    if not (script.copy.rule.kind == "DIRECTORY" or is_globbed) or scripts.starts.is_wanted(path):
        return False
    text = cmake.package_files.readable_text(path)
    return USES_ROS.search(text) is None or is_imported(scripts, path) or is_left_out(scripts, path)


def is_imported(scripts: InstalledScripts, path: str) -> bool:
    """Return whether another Python file of the package imports a module of that name."""
    files, name = scripts.package.cmake.package_files, posixpath.basename(path).removesuffix(".py")
    others = (files.readable_text(each) for each in files.paths if each.endswith(".py") and each != path)
    found = dotted_imports(text for text in others if name in text)
    return path.endswith(".py") and any(each.lstrip(".").rpartition(".")[2] == name for each in found)


def is_left_out(scripts: InstalledScripts, path: str) -> bool:
    """Return whether a comment of a CMake file names it, as a line does that was taken out of a rule."""
    named = re.compile(rf"{COMMENT}{re.escape(posixpath.basename(path))}(?![\w.-])", re.MULTILINE)
    return any(named.search(file.source.text) for file in scripts.package.cmake.files)

"""Nodes in Python that are no executable files, and that an install rule leaves out alone."""

from __future__ import annotations

import posixpath
import re
from collections.abc import Callable

from ...files import PackageFiles
from ...lazy_regex import regex

USES_ROS = regex(r"^[ \t]*(?:import|from)[ \t]+rclpy\b|\bros2[ \t]", re.MULTILINE)
MAIN = regex(r"^if[ \t(]+__name__\b", re.MULTILINE)
PYTHON = regex(r"#!.*\bpython")
FEW = 2
"""Nodes of a folder that don't show what is done with a third one."""


def is_left_out(path: str, files: PackageFiles, is_installed: Callable[[str], bool]) -> bool:
    """Return whether a file is the one node of its folder that is not installed."""
    folder = posixpath.dirname(path)
    nodes = [each for each in files.paths if posixpath.dirname(each) == folder and is_node(each, files)]
    return path in nodes and len(nodes) > FEW and [each for each in nodes if not is_installed(each)] == [path]


def is_last(path: str, files: PackageFiles, is_installed: Callable[[str], bool]) -> bool:
    """Return whether a node is the one Python file of its folder that is not installed."""
    folder = posixpath.dirname(path)
    others = [each for each in files.paths if posixpath.dirname(each) == folder and each.endswith(".py")]
    return is_node(path, files) and [each for each in others if not is_installed(each)] == [path]


def is_python(path: str, files: PackageFiles) -> bool:
    """Return whether a file is called so, or has no suffix and names Python in its first line."""
    is_bare = "." not in posixpath.basename(path)
    return path.endswith(".py") or (is_bare and PYTHON.match(files.readable_text(path)) is not None)


def is_node(path: str, files: PackageFiles) -> bool:
    if not is_python(path, files):
        return False
    text = files.readable_text(path)
    return USES_ROS.search(text) is not None and MAIN.search(text) is not None

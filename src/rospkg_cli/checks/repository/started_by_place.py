"""Launch files that pages and scripts start by their paths: behind `ros2 launch` stands no package."""

from __future__ import annotations

import posixpath
import re

from ...files import PackageFiles
from ...lazy_regex import regex
from .pages_and_scripts import pages_and_scripts
from .scripts_above import scripts_above

BY_PATH = regex(r"\b(?:ros2[ \t]+launch|python[\d.]*)[ \t]+(?:-\S+[ \t]+)*[\"']?([^\s`\"']+)")
HERE = ("", ".", "..")


def is_started_by_place(files: PackageFiles, package: str, folder: str) -> bool:
    """Return whether a text starts a launch file of a folder where it lies, and none has `ros2 launch` look it up."""
    texts = (*pages_and_scripts(files), *scripts_above(files))
    by_name = re.compile(rf"\bros2[ \t]+launch[ \t]+(?:-\S+[ \t]+)*{re.escape(package)}(?![\w/.-])")
    paths = files.below(folder)
    typed = (found[1] for text in texts for found in BY_PATH.finditer(text))
    is_started = any(names(each, path, files, package) for each in typed for path in paths)
    return is_started and not any(map(by_name.search, texts))


def names(typed: str, path: str, files: PackageFiles, package: str) -> bool:
    """Return whether a typed path is that of a file of the package, and of no other one that is called so."""
    if posixpath.basename(typed) != posixpath.basename(path):
        return False
    if not typed.endswith(f"/{path}"):
        return f"/{path}".endswith(f"/{typed.removeprefix('./')}")
    last = posixpath.basename(typed[: -len(path) - 1])
    return last in (*HERE, package, posixpath.basename(files.folder)) or "$" in last or not files.folder

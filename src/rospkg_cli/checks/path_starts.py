"""Programs that pages and scripts tell to start by their paths: Python looks next to such a file."""

from __future__ import annotations

import posixpath
import re

from ..files import PackageFiles
from .pages_and_scripts import pages_and_scripts

ALONE = "; the pages and scripts here start this file by its path alone, and there it is found"


def is_started_by_path(files: PackageFiles, path: str) -> bool:
    """Return whether a page or a script has Python run a file."""
    name = re.escape(posixpath.basename(path))
    started = re.compile(
        rf"(?m)^[^#\n]*\bpython[\d.]*[ \t]+(?:-[a-zA-Z]+[ \t]+)*[\"']?(?:[^\s\"';&|]*/)?{name}(?![\w.])"
    )
    return any(map(started.search, pages_and_scripts(files)))


def is_started_by_path_alone(files: PackageFiles, package: str, path: str) -> bool:
    """Return whether a text has Python run a file, and none has `ros2` run or launch something of its package."""
    by_name = re.compile(rf"\bros2[ \t]+(?:run|launch)[ \t]+{re.escape(package)}(?![\w-])")
    return is_started_by_path(files, path) and not any(map(by_name.search, pages_and_scripts(files)))

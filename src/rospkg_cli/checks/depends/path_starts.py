"""Programs that pages and scripts tell to start by their paths alone: Python looks next to such a file."""

from __future__ import annotations

import posixpath
import re

from ...files import PackageFiles
from ..pages_and_scripts import pages_and_scripts

ALONE = "; the pages and scripts here start this file by its path alone, and there it is found"


def is_started_by_path_alone(files: PackageFiles, package: str, path: str) -> bool:
    """Return whether a text has Python run a file, and none has `ros2` run or launch something of its package."""
    name = re.escape(posixpath.basename(path))
    by_path = re.compile(
        rf"(?m)^[^#\n]*\bpython[\d.]*[ \t]+(?:-[a-zA-Z]+[ \t]+)*[\"']?(?:[^\s\"';&|]*/)?{name}(?![\w.])"
    )
    by_name = re.compile(rf"\bros2[ \t]+(?:run|launch)[ \t]+{re.escape(package)}(?![\w-])")
    texts = pages_and_scripts(files)
    return any(map(by_path.search, texts)) and not any(map(by_name.search, texts))

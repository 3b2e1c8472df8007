"""Programs that pages and scripts tell to start by their paths: Python looks next to such a file."""

from __future__ import annotations

import posixpath
import re
from collections.abc import Iterator

from ...files import PackageFiles
from .pages_and_scripts import pages_and_scripts
from .scripts_above import scripts_above

IN_SOURCE = r"(?!\S*(?:\binstall/|/lib/|/share/))"
"""How a path goes on that leads into no installed package."""
APART = r"(?:[\"'],)?[ \t]+[\"']?"
"""What is between two words of a command, also of a list in JSON."""
ALONE = "; the pages and scripts here start this file by its path alone, and there it is found"


def is_started_by_path(files: PackageFiles, path: str, place: str = "") -> bool:
    """Return whether a page or a script has Python run a file, in a place as a pattern."""
    name = re.escape(posixpath.basename(path))
    words = rf"python[\d.]*{APART}(?:-[a-zA-Z]+{APART})*{place}(?:[^\s\"';&|]*/)?{name}"
    started = re.compile(rf"(?m)^[^#\n]*\b{words}(?![\w.])")
    return any(map(started.search, texts_of(files)))


def is_started_by_path_alone(files: PackageFiles, package: str, path: str, place: str = "") -> bool:
    """Return whether a text has Python run a file, and none has `ros2` run or launch something of its package."""
    by_name = re.compile(rf"\bros2{APART}(?:run|launch){APART}{re.escape(package)}(?![\w-])")
    return is_started_by_path(files, path, place) and not any(map(by_name.search, texts_of(files)))


def texts_of(files: PackageFiles) -> Iterator[str]:
    yield from pages_and_scripts(files)
    yield from scripts_above(files)

"""How long lines of Python may be: what the package says, or a folder above it, else what ament_flake8 wants."""

from __future__ import annotations

import re

from ..files import PackageFiles
from ..lazy_regex import regex
from ..unreadable import UnreadableError

AMENT_WIDTH = 99
"""Of ament_flake8's own configuration."""

SETTING = regex(r"^[ \t]*(?:max[-_])?line[-_]length[ \t]*=[ \t]*([0-9]{2,3})\b", re.MULTILINE)
CONFIGS = (".flake8", "setup.cfg", "tox.ini", "pyproject.toml", "ruff.toml", ".ruff.toml")
"""Where flake8, black and ruff look."""


def line_width(files: PackageFiles) -> int:
    """Return the width that the first config with one names."""
    for name in CONFIGS:
        if found := SETTING.search(text_of(files, name)):
            return int(found.group(1))
    return AMENT_WIDTH


def text_of(files: PackageFiles, name: str) -> str:
    """Return the text of a file of the package, or of the nearest above it; "" where there is none."""
    try:
        if files.has_file(name):
            return files.source(name).text
        above = files.above((name,))
        return files.whole.entry(above).text.text if files.whole is not None and above else ""
    except (UnreadableError, OSError, UnicodeError):
        return ""

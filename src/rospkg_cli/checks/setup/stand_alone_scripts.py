"""Folders of scripts that are run by their paths: Python modules that are not for import."""

from __future__ import annotations

import re
from collections.abc import Iterable

from ...files import PackageFiles
from ...lazy_regex import regex

SCRIPT = regex(r"\A#!|^if\s+__name__\s*==", re.MULTILINE)


def are_scripts(paths: Iterable[str], files: PackageFiles) -> bool:
    """Return whether each of some files begins with a shebang line or has a `__main__`."""
    return all(SCRIPT.search(files.readable_text(path)) for path in paths)

"""Programs whose start launch files have in comments alone."""

from __future__ import annotations

import re
from collections.abc import Iterable

from ..files import PackageFiles
from ..package.file_role import role_of

OWN = r"\b(?:package|pkg)\s*=\s*(?:[\"']{0}[\"']|[a-zA-Z_]\w*)"
"""The package of a node: by its name, or by a variable, which in most launch files holds that of their package."""
PROGRAM = r"\bexec(?:utable)?\s*=\s*[\"']{0}[\"']"
BETWEEN = r"[^()<>]{0,200}?"
"""Other arguments of the same node."""


def is_start_commented_out(files: PackageFiles, package: str, name: str, live: Iterable[str]) -> bool:
    """Return whether a launch file has the start of a program in a comment, and no file that starts programs names it.

    `live` are the texts of all such files without comments and without actions that are never added.
    """
    word = re.compile(rf"(?<![\w-]){re.escape(name)}(?![\w-])")
    if any(map(word.search, live)):
        return False
    own, program = OWN.format(re.escape(package)), PROGRAM.format(re.escape(name))
    start = re.compile(f"{own}{BETWEEN}{program}|{program}{BETWEEN}{own}")
    return any(start.search(files.readable_text(path)) for path in files.paths if role_of(path) == "launch")

"""Whether C++ code writes a file: a literal ends with its name where a stream or a call gets what it writes to."""

from __future__ import annotations

import posixpath
import re

from ...lazy_regex import regex
from .home_path_texts import without_comments

WRITES = regex(
    r"\bofstream\b|\bfopen\b[^;]*,\s*\"[wa]|\.open\([^;]*\bout\b|(?:imwrite|\b[sS]ave\w*|\b[wW]rite\w*)[ \t]*\("
)
"""What opens a file for writing, in one statement with its path."""
ENDS = regex(r";|\{[ \t]*\n|\}")
"""What ends a statement, or stands before one."""
BOUND = regex(r"(\w+)\s*(?:=|\{|\()[^=;]*$")
"""A variable, with the begin of what it gets."""


def is_written_in_cpp(code: str, text: str, path: str) -> bool:
    """Return whether the code in a file writes one of the folder and name of a path."""
    folder, name = posixpath.split(path)
    in_folder = rf"(?:(?:[^\"\n]*/)?{re.escape(posixpath.basename(folder))})?/+" if folder else r"[^\"\n]*/"
    live = without_comments(code, text)
    for found in re.finditer(rf"\"(?:{in_folder})?{re.escape(name)}\"", live):
        start = max((each.end() for each in ENDS.finditer(live, 0, found.start())), default=0)
        end = ENDS.search(live, found.end())
        if WRITES.search(live[start : end.start() if end else len(live)]):
            return True
        bound = BOUND.search(live[start : found.start()])
        if bound is not None and is_opened(bound[1], live):
            return True
    return False


def is_opened(variable: str, text: str) -> bool:
    """Return whether a statement opens what a variable holds for writing."""
    name = rf"\s*{re.escape(variable)}\b"
    made = rf"(?:\bofstream\s+\w+|\bofstream|\bimwrite|\b[sS]ave\w*|\b[wW]rite\w*)[ \t]*[({{]{name}"
    opened = rf"\.open\({name}[^;]*\bout\b|\bfopen\({name}[^;]*,\s*\"[wa]"
    late = rf"\.open\({name}" if re.search(r"\bofstream\b", text) else r"(?!)"
    return re.search(f"{made}|{opened}|{late}", text) is not None

"""Where XML names a package: launch files, robot descriptions, descriptions of plugins."""

from __future__ import annotations

import re
from collections.abc import Iterator

from ..lazy_regex import regex
from ..source import Source, Span
from .patterns import found
from .renamed_package import RenamedPackage

ATTRIBUTES = (
    r"""\b(?:\w+_)?(?:pkg|package)(?:_name)?\s*=\s*(?P<quote>["'])%NAME%(?P=quote)""",
    r"""<(?:arg|let|param|xacro:\w+)\b[^<>]*\bname\s*=\s*["']\w*(?:package|pkg)\w*["'][^<>]*\b(?:default|value)\s*=\s*["']%NAME%["']""",
)
LIBRARY = (
    r"""<library\s+path\s*=\s*["'](?:[\w./-]*/)?(?:lib)?%PART%(?=["'])""",
    r"""\bfilename\s*=\s*["']%PART%(?=["'])""",
)
TAG = regex(r"<[A-Za-z][\w:]*\s[^<>]*>")
EXECUTABLE = r"""\bexec\s*=\s*["']%NAME%["']"""


def in_markup(source: Source, renamed: RenamedPackage) -> Iterator[Span]:
    """Yield the places; a node's executable follows where it has the package's name."""
    yield from found(ATTRIBUTES, source.text, renamed.old)
    yield from found(LIBRARY, source.text, renamed.old, renamed.libraries)
    if renamed.executables:
        for tag in TAG.finditer(source.text):
            if re.search(rf"""\bpkg\s*=\s*["']{re.escape(renamed.old)}["']""", tag.group()):
                for span in found((EXECUTABLE,), tag.group(), renamed.old, renamed.executables):
                    yield Span(tag.start() + span.start, tag.start() + span.end)

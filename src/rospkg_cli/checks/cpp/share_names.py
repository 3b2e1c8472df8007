"""Packages whose share directory or prefix C++ looks for by a literal name."""

from __future__ import annotations

from collections.abc import Iterator

from ...languages.cpp.code_text import code_text
from ...languages.cpp.file import CppFile
from ...lazy_regex import regex
from ...source import Span

LOOKUP = regex(r"\bget_package_(?:share_directory|share_path|prefix)\s*\(")
NAME = regex(r'\s*"([A-Za-z]\w*)"\s*\)')
CAUGHT = "PackageNotFoundError"


def share_names(file: CppFile) -> Iterator[tuple[str, Span]]:
    """Yield each name with its place between the quotes; none where the file catches that a package is not there."""
    text = file.source.text
    if "get_package_" not in text or CAUGHT in text:
        return  # before the comments are found, which takes longer
    for call in LOOKUP.finditer(code_text(text)):
        if found := NAME.match(text, call.end()):
            yield found[1], Span(*found.span(1))

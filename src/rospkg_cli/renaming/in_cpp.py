"""Where C and C++ name a package: in includes, in what generated code is called, and where its files are looked for."""

from __future__ import annotations

import re
from collections.abc import Iterator

from ..lazy_regex import regex
from ..source import Source, Span
from .patterns import found, pattern
from .renamed_package import RenamedPackage

INCLUDE = r"""^[ \t]*#[ \t]*(?:include|import)[ \t]*[<"]%PART%/(?P<inner>[^>"\n]+)[>"]"""
LOOKUPS = (
    r"""\w*(?:[Pp]ackage|PACKAGE|pkg|PKG)\w*\s*(?:=|\(|\{|\s)\s*"%NAME%\"""",
    r"""\bClassLoader\s*<[^;"]*>\s*\w*\s*[({]\s*"%NAME%\"""",
    r"""[({]\s*"%NAME%"\s*,\s*"\w+(?:::\w+)+\"""",
    r"""\bget_resource\(\s*"\w+"\s*,\s*"%NAME%\"""",
)
"""`get_package_share_directory("…")`, and `ClassLoader<Base>("…", "base::Class")`, whose type may stand elsewhere."""
GUARD = regex(r"^[ \t]*#[ \t]*(?:ifndef|define|endif[ \t]*(?://|/\*))[ \t]*(?P<macro>[A-Z0-9_]+)", re.MULTILINE)


def in_cpp(source: Source, renamed: RenamedPackage) -> Iterator[Span]:
    """Yield the places; namespaces that people wrote are left."""
    for match in pattern(INCLUDE, renamed.old).finditer(source.text):
        if match["inner"] not in renamed.others:
            yield Span(*match.span("name"))
    yield from found(LOOKUPS, source.text, renamed.old)


def guards(source: Source, renamed: RenamedPackage) -> Iterator[Span]:
    """Yield the name in the guard of a header whose path has it, in capitals, as linters want it."""
    upper = renamed.old.upper()
    for match in GUARD.finditer(source.text):
        macro = match["macro"]
        if macro.startswith((f"{upper}_", f"_{upper}_")) and macro.rstrip("_").endswith(("_H", "_HPP", "_HH", "_HXX")):
            start = match.start("macro") + macro.index(upper)
            yield Span(start, start + len(upper))

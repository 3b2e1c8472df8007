"""Where YAML names a package: under keys that say so, in launch files, workflows and lists."""

from __future__ import annotations

import re
from collections.abc import Iterator

from ..lazy_regex import regex
from ..source import Source, Span
from .patterns import found, words
from .renamed_package import RenamedPackage

KEYS = (
    r"^[ \t-]*packages?[-_](?:names?|select|skip|up[-_]to)\w*[ \t]*:.*?%NAME%",
    r"""^[ \t-]*["']?[\w-]*(?:pkg|package)(?:s|[-_]name)?["']?[ \t]*:[ \t]*(?P<quote>["']?)%NAME%(?P=quote)"""
    r"""[ \t]*(?:#|$)""",
)
BLOCK = regex(
    r"^(?P<indent>[ ]*)(?:-[ ]+)?[\w-]*packages?(?:[-_]names?)?[ ]*:[ ]*[>|]?[-+]?[ ]*\n"
    r"(?P<body>(?:(?P=indent)[ ]+\S.*\n?|[ ]*\n)+)",
    re.MULTILINE,
)
"""A key with names of packages, one a line."""


def in_yaml(source: Source, renamed: RenamedPackage) -> Iterator[Span]:
    """Yield the places; a node's executable follows where it has the package's name."""
    yield from found(KEYS, source.text, renamed.old)
    for block in BLOCK.finditer(source.text):
        lines = re.finditer(
            rf"^[ -]*[\"']?(?P<name>{re.escape(renamed.old)})[\"']?[ \t]*(?:#.*)?$", block["body"], re.MULTILINE
        )
        for line in lines:
            yield Span(block.start("body") + line.start("name"), block.start("body") + line.end("name"))
    if renamed.has_executable:
        yield from executables(source.text, renamed.old)


def executables(text: str, name: str) -> Iterator[Span]:
    """Yield the name where it is the executable next to a package of the same name."""
    word = re.escape(name)
    pair = rf"""^[ -]*pkg:[ ]*["']?{word}["']?[ \t]*\n[ ]*exec:[ ]*["']?{word}["']?[ \t]*$"""
    for match in re.finditer(pair, text, re.MULTILINE):
        *_, last = words(match.group(), name)
        yield Span(match.start() + last.start, match.start() + last.end)

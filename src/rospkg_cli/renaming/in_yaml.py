"""Where YAML names a package: under keys that say so, in launch files, workflows and lists."""

from __future__ import annotations

import re
from collections.abc import Iterator

from ..lazy_regex import regex
from ..source import Source, Span
from .patterns import found
from .renamed_package import RenamedPackage

KEYS = (
    r"^[ \t-]*packages?[-_](?:names?|select|skip|up[-_]to)\w*[ \t]*:.*?%NAME%",
    r"""^[ \t-]*["']?[\w-]*(?:pkg|package)(?:s|[-_]name)?["']?[ \t]*:[ \t]*(?P<quote>["']?)%NAME%(?P=quote)"""
    r"""[ \t]*(?:#|$)""",
)
EXECUTABLE = r"""^[ -]*pkg:[ ]*["']?%WORD%["']?[ \t]*\n[ ]*exec:[ ]*["']?%NAME%["']?[ \t]*$"""
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
    yield from found((EXECUTABLE,), source.text, renamed.old, renamed.executables)

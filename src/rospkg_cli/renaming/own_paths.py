"""Where files of a package name its own folders by their paths."""

from __future__ import annotations

import re
from collections.abc import Iterator

from ..source import Span
from .patterns import found
from .renamed_package import RenamedPackage


def own_paths(text: str, renamed: RenamedPackage, folder: str = "") -> Iterator[Span]:
    """Yield the name in each path to a folder that moves; a path begins in the package, or in the file's folder.

    What stands before it in braces (`${PROJECT_SOURCE_DIR}/`) is one of these two. A single word is no path.
    """
    name = re.escape(renamed.old)
    for match in re.finditer(rf"(?:(?<=\}}/)|(?<![\w./-]))(?P<before>(?:[\w.-]+/)*)(?P<name>{name})(?![\w.-])", text):
        before = match["before"].removeprefix("./")
        is_path = before or text.startswith("/", match.end())
        places = {f"{before}{renamed.old}", f"{folder}/{before}{renamed.old}".lstrip("/")}
        if is_path and places & renamed.moved:
            yield Span(*match.span("name"))


def file_names(text: str, renamed: RenamedPackage) -> Iterator[Span]:
    """Yield the name in the names of files that move since CMake makes theirs of the project's: `OLD_node.cpp`."""
    for file in sorted({path.rpartition("/")[2] for path in renamed.moved} - {renamed.old}):
        before, _, behind = file.partition(renamed.old)
        yield from found((r"(?<![\w.-])%PART%(?![\w-]|\.\w)",), text, renamed.old, ((before, behind),))

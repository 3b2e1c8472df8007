"""Where lists of paths name a folder that moves: .gitignore and its like."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator

from ..source import Span

LISTS = frozenset({".gitignore", ".dockerignore", ".gitattributes", "CODEOWNERS", "MANIFEST.in"})


def folder_paths(text: str, folder: str, name: str, moves: Iterable[str]) -> Iterator[Span]:
    """Yield the name in each path below a folder that leads to something which moves; `moves` are from the root."""
    known = frozenset(moves)
    for match in re.finditer(rf"(?<![^\s/!]){re.escape(name)}(?=/|\s|$)", text):
        line = text.rfind("\n", 0, match.start()) + 1
        before = text[line : match.start()].lstrip("!/")
        if f"{folder}/{before}{name}".lstrip("/") in known:
            yield Span(*match.span())

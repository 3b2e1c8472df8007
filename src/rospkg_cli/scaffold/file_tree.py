"""A folder as a picture of lines, each file with what it is for."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from typing import Any

from ..light_dataclasses import dataclass, replace

LINES = "├└│─"
"""The signs that a tree is drawn with."""
ASCII = str.maketrans(LINES, "|`|-")


@dataclass(frozen=True)
class TreeRow:
    lines: str
    """What is drawn before the name."""
    name: str
    """A folder's ends in `/`."""
    about: str = ""

    @property
    def drawn(self) -> str:
        return self.lines + self.name


def in_ascii(rows: Iterable[TreeRow]) -> list[TreeRow]:
    """Return rows drawn with the signs that every encoding has."""
    return [replace(row, lines=row.lines.translate(ASCII)) for row in rows]


def tree_rows(root: str, about: Mapping[str, str]) -> list[TreeRow]:
    """Return the rows of a tree; `about` is path to a few words."""
    return [TreeRow("", f"{root}/"), *branches(nested(about), "")]


def nested(about: Mapping[str, str]) -> dict[str, Any]:
    """Return folders as dicts of their entries, files as what they are for."""
    root: dict[str, Any] = {}
    for path, words in about.items():
        *folders, name = path.split("/")
        inner = root
        for folder in folders:
            inner = inner.setdefault(folder, {})
        inner[name] = words
    return root


def branches(folder: dict[str, Any], before: str) -> Iterator[TreeRow]:
    """Yield the rows below a folder: its folders first, each part by name."""
    entries = sorted(folder.items(), key=lambda entry: (not isinstance(entry[1], dict), entry[0].lower()))
    for number, (name, inside) in enumerate(entries, 1):
        last = number == len(entries)
        lines = before + ("└── " if last else "├── ")
        if isinstance(inside, dict):
            yield TreeRow(lines, f"{name}/")
            yield from branches(inside, before + ("    " if last else "│   "))
        else:
            yield TreeRow(lines, name, inside)

"""Read the tables of names that lie beside this module: facts, a line each, `#` before a comment."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cache
from pathlib import Path

FOLDER = Path(__file__).parent / "tables"


def lines(name: str) -> Iterator[str]:
    """Yield the lines of a table that say something."""
    text = (FOLDER / name).read_text(encoding="utf-8")
    return (line for line in text.split("\n") if line and line[0] != "#")


@cache
def marked(name: str) -> dict[str, tuple[str, ...]]:
    """Return each name of a table with the words of the `[heading]` that it stands under."""
    found: dict[str, tuple[str, ...]] = {}
    mark: tuple[str, ...] = ()
    for line in lines(name):
        if line[0] == "[":
            mark = tuple(line[1:-1].split())
        else:
            found[line] = mark
    return found


@cache
def rows(name: str) -> dict[str, tuple[str, ...]]:
    """Return the first word of each line of a table with the words behind it."""
    found: dict[str, tuple[str, ...]] = {}
    for line in lines(name):
        first, *rest = line.split()
        found[first] = found.get(first, ()) + tuple(rest)
    return found

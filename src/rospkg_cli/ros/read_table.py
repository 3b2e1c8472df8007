"""Read the tables of ROS knowledge in `tables/`: names, a line each.

A table begins with a header of comments: what it holds, then `source:`, `commit:`, `date:`, `license:` (of the source)
and `made by:` (a script of `bench/`, or `hand`).  Below it `#` begins a comment and `[words]` a section.  A row is a
name and the words behind it; a name may have several rows.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from functools import cache
from pathlib import Path

FOLDER = Path(__file__).parent / "tables"


def lines(name: str) -> Iterator[str]:
    """Yield the rows and the headings of a table."""
    text = (FOLDER / name).read_text(encoding="utf-8")
    return (line for line in text.split("\n") if line and line[0] != "#")


@cache
def marked(name: str) -> dict[str, tuple[str, ...]]:
    """Return each name of a table with the words of its section's heading."""
    found: dict[str, tuple[str, ...]] = {}
    mark: tuple[str, ...] = ()
    for line in lines(name):
        if line[0] == "[":
            mark = tuple(line[1:-1].split())
        else:
            found[line] = mark
    return found


@cache
def sections(name: str) -> dict[str, dict[str, tuple[str, ...]]]:
    """Return the rows of each section; those before the first heading are in the section ""."""
    rows: dict[str, tuple[str, ...]] = {}
    found = {"": rows}
    for line in lines(name):
        if line[0] == "[":
            rows = found.setdefault(line[1:-1], {})
        else:
            first, *rest = line.split()
            rows[first] = rows.get(first, ()) + tuple(rest)
    return found


def rows(name: str, section: str = "") -> dict[str, tuple[str, ...]]:
    """Return each name of a section with the words behind it."""
    return sections(name)[section]


def sets(name: str, section: str = "") -> dict[str, frozenset[str]]:
    """Return each name of a section with the set of the words behind it."""
    return {first: frozenset(rest) for first, rest in rows(name, section).items()}


def pairs(name: str, section: str = "") -> dict[str, str]:
    """Return each name of a section with the one word behind it."""
    return {first: word for first, (word,) in rows(name, section).items()}


def words(name: str, section: str = "") -> frozenset[str]:
    """Return all words of a section."""
    return frozenset(word for first, rest in rows(name, section).items() for word in (first, *rest))


def phrases(name: str) -> dict[str, tuple[str, ...]]:
    """Return each name of a table with the phrases behind it, which ` | ` separates."""
    split = (line.split(" | ") for line in lines(name))
    return {first: tuple(rest) for first, *rest in split}


def unfolded(words: Iterable[str], parts: Mapping[str, tuple[str, ...]]) -> Iterator[str]:
    """Yield the words of a row, those of a part in the place of its name."""
    for word in words:
        if word in parts:
            yield from unfolded(parts[word], parts)
        else:
            yield word

"""The patterns of .gitignore files, as gitignore(5) has them, in bounded time."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from fnmatch import fnmatchcase
from functools import lru_cache

from .lazy_regex import regex
from .light_dataclasses import dataclass

SPECIAL = regex(r"[*?\[]")
MAX_PATTERNS = 5_000
MAX_LENGTH = 500
"""In characters, of one pattern; a longer one is passed over, as is one with more than two `**`."""


@dataclass(frozen=True, slots=True)
class IgnorePattern:
    parts: tuple[str, ...]
    """A shell pattern for each part of a path, `**` for any number of them."""
    is_negated: bool


def read_patterns(text: str) -> tuple[IgnorePattern, ...]:
    lines = (line.rstrip() for line in text.splitlines()[:MAX_PATTERNS])
    return tuple(pattern for line in lines if (pattern := read_pattern(line)) is not None)


def read_pattern(line: str) -> IgnorePattern | None:
    """Return a line's pattern; None for a comment, and for what is empty or too long."""
    is_negated = line.startswith("!")
    body = line[is_negated:].removeprefix("\\").rstrip("/")
    is_anchored = "/" in body
    parts = tuple(part for part in body.split("/") if part)
    if line.startswith("#") or not parts or len(line) > MAX_LENGTH or parts.count("**") > 2:
        return None
    return IgnorePattern(parts if is_anchored else ("**", *parts), is_negated)


def is_ignored(path: str, patterns: Mapping[str, Sequence[IgnorePattern]]) -> bool:
    """Return whether git ignores a path or a folder above it; `patterns` are by the folder of their .gitignore."""
    parts = path.split("/")
    return any(is_level_ignored(parts[:end], patterns) for end in range(1, len(parts) + 1))


def is_level_ignored(parts: Sequence[str], patterns: Mapping[str, Sequence[IgnorePattern]]) -> bool:
    """Return what the last pattern that fits says: those of the nearest folder come last."""
    for depth in range(len(parts) - 1, -1, -1):
        for pattern in reversed(patterns.get("/".join(parts[:depth]), ())):
            if fits(pattern.parts, parts[depth:]):
                return not pattern.is_negated
    return False


def fits(pattern: Sequence[str], parts: Sequence[str]) -> bool:
    if not pattern or not parts:
        return not pattern and not parts
    if pattern[0] == "**":
        rest = pattern[1:]
        if len(rest) == 1 and rest[0] != "**":
            return is_match(parts[-1], rest[0])
        return not rest or any(fits(rest, parts[start:]) for start in range(len(parts)))
    return is_match(parts[0], pattern[0]) and fits(pattern[1:], parts[1:])


@lru_cache(maxsize=4096)
def is_match(part: str, pattern: str) -> bool:
    return fnmatchcase(part, pattern) if SPECIAL.search(pattern) else part == pattern


def folders_above(path: str) -> Iterator[str]:
    """Yield the folders whose .gitignore may name a path: "" first."""
    parts = path.split("/")
    return ("/".join(parts[:depth]) for depth in range(len(parts)))

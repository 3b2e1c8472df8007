"""CMake's regular expressions and globs, where they can be run in bounded time."""

from __future__ import annotations

import re
from collections.abc import Iterable
from functools import cache

from ...lazy_regex import regex

MAX_STEPS = 2_000_000
QUANTIFIERS = regex(r"\\.|\[\^?\]?[^\]]*\]|([*+])", re.DOTALL)
REPEATED_GROUP = regex(r"\)[*+]|\(\?")


@cache
def compile_regex(pattern: str) -> tuple[re.Pattern[str], int] | None:
    """Return the pattern and the exponent of its worst run time, None where it is not evaluated.

    CMake knows `.`, `[]`, `*`, `+`, `?`, `|`, `()`, `^`, `$`; braces are ordinary characters.
    """
    if len(pattern) > 300 or REPEATED_GROUP.search(pattern):
        return None
    power = sum(1 for match in QUANTIFIERS.finditer(pattern) if match.group(1)) + (not pattern.startswith("^"))
    try:
        return re.compile(pattern.replace("{", "\\{").replace("}", "\\}"), re.DOTALL), power
    except (re.error, RecursionError, OverflowError):
        return None


def max_steps(pattern: str, subject: str) -> int:
    """Return how many steps a search may take at most, 0 where it is not evaluated."""
    found = compile_regex(pattern)
    most = 0 if found is None else (len(subject) + 1) ** found[1]
    return most if most <= MAX_STEPS else 0


def affordable_regex(pattern: str, subject: str) -> re.Pattern[str] | None:
    found = compile_regex(pattern)
    if found is None or (len(subject) + 1) ** found[1] > MAX_STEPS:
        return None
    return found[0]


def search(pattern: str, subject: str) -> bool | None:
    """Return whether a pattern matches anywhere in a text; None where that is not evaluated."""
    found = affordable_regex(pattern, subject)
    return None if found is None else found.search(subject) is not None


def find_all(pattern: str, subject: str) -> list[str] | None:
    """Return all matches; None where that is not evaluated."""
    found = affordable_regex(pattern, subject)
    return None if found is None else [match.group() for match in found.finditer(subject)]


def replace_all(pattern: str, replacement: str, subject: str) -> str | None:
    """Return the text with every match replaced (`\\1` names a group); None where that is not evaluated."""
    found = affordable_regex(pattern, subject)
    if found is None:
        return None

    def group(match: re.Match[str], number: int) -> str:
        return match.group(number) or "" if number <= match.re.groups else ""

    def fill(match: re.Match[str]) -> str:
        return re.sub(r"\\(\d)", lambda digit: group(match, int(digit.group(1))), replacement)

    return found.sub(fill, subject)


@cache
def glob_pattern(pattern: str) -> re.Pattern[str] | None:
    """Return the regular expression of a glob, in which `*` and `?` do not cross `/`; None for one with too many."""
    pieces = re.split(r"(\[[^\]]*\]|\*+|\?)", pattern)
    if sum(piece.startswith("*") for piece in pieces) > 6:
        return None
    try:
        return re.compile("".join(map(glob_piece, pieces)) + r"\Z", re.DOTALL)
    except re.error:
        return None


def glob_piece(piece: str) -> str:
    if piece.startswith("*"):
        return "[^/]*"
    if piece == "?":
        return "[^/]"
    if len(piece) > 2 and piece.startswith("["):
        return "[" + piece[1:-1].replace("\\", "\\\\").replace("[", "\\[").replace("!", "^", 1) + "]"
    return re.escape(piece)


def glob(pattern: str, paths: Iterable[str]) -> list[str] | None:
    """Return the paths that match a glob; None where it is not evaluated."""
    found = glob_pattern(pattern)
    return None if found is None else [path for path in paths if found.match(path)]

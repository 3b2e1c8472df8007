"""Lines of a width: broken between words, never inside of a place or of `code` that fits into a line."""

from __future__ import annotations

import os
import sys
from collections.abc import Iterable
from typing import IO

from ..control_characters import without_workflow_commands
from ..lazy_regex import regex
from .color import paint

Word = tuple[str, str]
"""A word as it is printed, and the name of its colour ("" for none)."""

WORD = regex(r"(?:`[^`\n]*`|\S)+")
"""Blanks between backticks don't end a word."""

NARROWEST = 20
"""Columns; on a narrower terminal nothing can be read anyway."""


def terminal_width(stream: IO[str]) -> int | None:
    """Return the columns of a terminal ($COLUMNS first); None for a stream that is none, where no line is broken."""
    if not stream.isatty():
        return None
    typed = os.environ.get("COLUMNS", "")
    try:
        columns = int(typed) if typed.isdecimal() else os.get_terminal_size(sys.__stdout__.fileno()).columns  # type: ignore[union-attr]
    except (AttributeError, OSError, ValueError):
        columns = 80
    return max(columns or 80, NARROWEST)


def words(text: str, color: str = "") -> list[Word]:
    """Return the words of a text."""
    return [(word, color) for word in WORD.findall(text)]


def wrapped(
    found: Iterable[Word], width: int | None, first: str = "", rest: str | None = None, color: bool = False
) -> list[str]:
    """Return lines of words, the first behind `first` and the others behind `rest`; one line where width is None."""
    rest = first if rest is None else rest
    lines: list[list[Word]] = [[]]
    used = len(first)
    for word in found:
        for part in fitting(word, None if width is None else width - len(rest)):
            if lines[-1] and width is not None and used + 1 + len(part[0]) > width:
                lines.append([])
                used = len(rest)
            used += len(part[0]) + bool(lines[-1])
            lines[-1].append(part)
    painted = (" ".join(paint(text, name, color) if name else text for text, name in line) for line in lines)
    return [without_workflow_commands((rest if number else first) + line) for number, line in enumerate(painted)]


def fitting(word: Word, room: int | None) -> list[Word]:
    """Return a word; in parts where it is code that holds blanks and is too long for a line."""
    text, color = word
    if room is None or len(text) <= room or "`" not in text:
        return [word]
    return [(part, color) for part in text.split()]

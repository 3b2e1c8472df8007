"""Find positions in C++ code that are unconditional in their function: no `if`, loop or lambda around them."""

from __future__ import annotations

import re
from collections.abc import Iterable

from ...lazy_regex import regex
from ...light_dataclasses import dataclass, field
from .call import PIECE

CONTROL = frozenset({"if", "for", "while", "switch", "catch", "else", "do", "constexpr"})
COMMENT = regex(r"//[^\n]*|/\*.*?\*/", re.DOTALL)
MAX_STATEMENT = 4_000
"""A longer statement counts as conditional."""
HEADER = regex(r"\b(?:if|else|for|while|case|default|catch|do)\b|\?|&&|\|\|")


@dataclass(slots=True)
class Bracket:
    """An open bracket."""

    brace: bool
    control: bool
    """A block of a condition, a loop or a lambda."""
    head: str = ""
    """The last word before a parenthesis, or `]` for a lambda."""


@dataclass(slots=True)
class BracketStack:
    """The open brackets, innermost last."""

    all: list[Bracket] = field(default_factory=list)
    blocks: int = 0
    conditions: int = 0
    """How many of the blocks belong to a condition, a loop or a lambda."""

    def open(self, level: Bracket) -> None:
        self.all.append(level)
        self.count(level, 1)

    def close(self) -> Bracket:
        level = self.all.pop()
        self.count(level, -1)
        return level

    def count(self, level: Bracket, by: int) -> None:
        self.blocks += by * level.brace
        self.conditions += by * (level.brace and level.control)


def unconditional(text: str, places: Iterable[int], control: frozenset[str] = CONTROL) -> set[int]:
    """Return the offsets that are directly in the body of a function, in one pass over the text.

    `control` are the words before blocks that count as conditions.
    """
    waiting, found = sorted(places, reverse=True), set()
    levels = BracketStack()
    statement, closed = 0, Bracket(False, False)
    for match in PIECE.finditer(text):
        while waiting and waiting[-1] < match.start():
            at = waiting.pop()
            if levels.blocks and not levels.conditions and is_plain(text, statement, at):
                found.add(at)
        if not waiting:
            break
        kind, char = match.lastgroup, match.group()
        if kind == "open":
            before = text[max(0, match.start() - 60) : match.start()].rstrip()
            head = "]" if before.endswith("]") else last_word(before)
            if char == "{":
                behind = closed.head if before.endswith(")") else head
                levels.open(Bracket(True, behind in control or behind == "]"))
                statement = match.end()
            else:
                levels.open(Bracket(False, False, head))
        elif kind == "close" and levels.all:
            closed = levels.close()
            statement = match.end() if char == "}" else statement
    return found


def last_word(before: str) -> str:
    """Return the word that a text ends with, "" where it ends with something else."""
    start = len(before)
    while start and (before[start - 1].isalnum() or before[start - 1] == "_"):
        start -= 1
    return before[start:]


def is_plain(text: str, start: int, at: int) -> bool:
    """Return whether a statement, from `start` to a position in it, holds nothing conditional."""
    begin = max(start, text.rfind(";", start, at) + 1)
    return at - begin < MAX_STATEMENT and not HEADER.search(COMMENT.sub("", text[begin:at]))

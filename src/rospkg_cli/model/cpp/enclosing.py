"""Whether places in C++ code are reached whenever their function is: no `if`, loop or lambda around them."""

from __future__ import annotations

import re
from collections.abc import Iterable
from dataclasses import dataclass

from .call import PIECE

WORD = re.compile(r"(\w+)\s*$")
CONTROL = frozenset({"if", "for", "while", "switch", "catch", "else", "do", "constexpr"})
COMMENT = re.compile(r"//[^\n]*|/\*.*?\*/", re.DOTALL)
HEADER = re.compile(r"\b(?:if|else|for|while|case|default|catch|do)\b|\?|&&|\|\|")


@dataclass(slots=True)
class Level:
    """An open bracket."""

    brace: bool
    control: bool
    """A block of a condition, a loop or a lambda."""
    head: str = ""
    """What a parenthesis stands behind: the last word, or `]` for a lambda."""


def unconditional(text: str, places: Iterable[int]) -> set[int]:
    """Return those of the offsets that stand directly in the body of a function, in one pass over the text."""
    waiting, found = sorted(places, reverse=True), set()
    levels: list[Level] = []
    statement, closed = 0, Level(False, False)
    for match in PIECE.finditer(text):
        while waiting and waiting[-1] < match.start():
            at = waiting.pop()
            if is_plain(levels, text[max(statement, text.rfind(";", statement, at) + 1) : at]):
                found.add(at)
        if not waiting:
            break
        kind, char = match.lastgroup, match.group()
        if kind == "open":
            before = text[max(0, match.start() - 60) : match.start()].rstrip()
            head = "]" if before.endswith("]") else (word.group(1) if (word := WORD.search(before)) else "")
            if char == "{":
                behind = closed.head if before.endswith(")") else head
                levels.append(Level(True, behind in CONTROL or behind == "]"))
                statement = match.end()
            else:
                levels.append(Level(False, False, head))
        elif kind == "close" and levels:
            closed = levels.pop()
            statement = match.end() if char == "}" else statement
    return found


def is_plain(levels: list[Level], before: str) -> bool:
    """Return whether neither a block around a place nor its own statement is conditional."""
    blocks = [level for level in levels if level.brace]
    return bool(blocks) and not any(level.control for level in blocks) and not HEADER.search(COMMENT.sub("", before))

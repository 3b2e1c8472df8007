"""The comments in lines of Python, C++, CMake, YAML or XML, and which lines they belong to."""

from __future__ import annotations

from collections.abc import Iterator

from ...lazy_regex import regex

COMMENT = regex(r"(?:^|\s)(?:#|//|<!--)(.*)")
OPENING = regex(r"\s*<[\w:]+(?:\s[^<>]*)?(?<!/)>\s*|.*[(\[{]\s*|\s*[\"'][\w/]+[\"'],\s*")
"""A line that only opens what the next one is a part of."""
STEPS = 3
"""How many such lines may stand between a comment and what it is about."""


def comment_blocks(text: str) -> Iterator[str]:
    """Yield what comments say, those of lines that follow each other as one."""
    block: list[str] = []
    for line in (*text.split("\n"), ""):
        if said := comment_in(line):
            block.append(said)
        elif block:
            yield "\n".join(block)
            block = []


def comments_behind(lines: list[str], at: int) -> Iterator[str]:
    for line in lines[at:]:
        if is_outer(line, lines[at]):
            return
        yield comment_in(line)


def is_outer(line: str, inner: str) -> bool:
    """Return whether a line is outside of the block of another one."""
    return bool(line.strip()) and indent(line) < indent(inner)


def indent(line: str) -> int:
    return len(line) - len(line.lstrip())


def comment_in(line: str) -> str:
    found = COMMENT.search(line)
    return found[1].strip(" \t#/*-=<>!") or " " if found is not None else ""


def without_opening(lines: list[str]) -> list[str]:
    """Return lines without the last few that only open what the next line is a part of."""
    end = len(lines)
    while end and len(lines) - end < STEPS and opens(lines[end - 1]):
        end -= 1
    return lines[:end]


def opens(line: str) -> bool:
    return OPENING.fullmatch(line) is not None and COMMENT.match(line.strip()) is None

"""Add an item to a bracketed list of Python, or remove one; layout, comments and trailing comma stay."""

from __future__ import annotations

import re
from collections.abc import Sequence

from ..finding import Edit
from ..lazy_regex import regex
from ..source import Source, Span

COMMA = regex(r"(?:\s|#[^\n]*\n)*,")
"""The comma behind an item, wherever it stands; linear, as it is only tried behind the item."""

LINE_END = regex(r"[ \t]*(?:#[^\n]*)?$", re.MULTILINE)
"""Nothing more in this line, but perhaps a comment; linear, as it is only tried at one offset."""


def append(source: Source, brackets: Span, items: Sequence[Span], code: str) -> tuple[Edit, ...]:
    """Put an item behind the last one; `brackets` spans the list with its brackets.

    Where a comma has to come first, the edit takes a character of the list with it: two such edits at one place are
    not to be made at once.
    """
    inside = [item for item in items if brackets.start < item.start and item.end < brackets.end]
    if not inside:
        at = Span(brackets.end - 1, brackets.end)
        return (Edit(source.path, at, code + source.slice(at)),)
    last = max(inside, key=lambda item: item.end)
    comma = COMMA.match(source.text, last.end)
    line = f"\n{indent_of(source, last.start)}{code}" if begins_line(source, last.start) else f" {code}"
    end = comma.end() if comma else last.end
    rest = LINE_END.match(source.text, end) if line.startswith("\n") else None
    if comma:
        at = Span(rest.end(), rest.end()) if rest else Span(end, end)
        return (Edit(source.path, at, f"{line},"),)
    tail, here = source.text[end - 1 : end], Span(end - 1, end)
    if rest is None:
        return (Edit(source.path, here, f"{tail},{line}"),)
    if not rest.group().strip():
        return (Edit(source.path, here, f"{tail},{line},"),)
    return Edit(source.path, here, f"{tail},"), Edit(source.path, Span(rest.end(), rest.end()), f"{line},")


def remove(source: Source, item: Span) -> Edit:
    """Remove an item with its comma; with its lines where they hold nothing else."""
    text = source.text
    comma = COMMA.match(text, item.end)
    end = comma.end() if comma else item.end
    rest = LINE_END.match(text, end)
    if begins_line(source, item.start) and rest is not None:
        start = source.line_span(source.position(item.start)[0]).start
        return Edit(source.path, Span(start, min(rest.end() + 1, len(text))), "")
    if comma:
        while text[end : end + 1] in (" ", "\t"):
            end += 1
        return Edit(source.path, Span(item.start, end), "")
    before = text[: item.start].rstrip()
    return Edit(source.path, Span(len(before) - 1 if before.endswith(",") else item.start, item.end), "")


def begins_line(source: Source, at: int) -> bool:
    """Return whether the line holds only blanks before an offset."""
    line = source.line_span(source.position(at)[0])
    return not source.text[line.start : at].strip()


def indent_of(source: Source, at: int) -> str:
    line = source.line_span(source.position(at)[0])
    text = source.text[line.start : at]
    return text[: len(text) - len(text.lstrip())]


def deeper(indent: str) -> str:
    """Return the blanks of a line that is one level deeper, in tabs where these are."""
    return indent + ("\t" if indent.endswith("\t") else "    ")

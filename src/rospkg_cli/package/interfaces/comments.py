"""Comments of an interface file: rosidl copies them, and a unit like `[m/s]`, into the .idl file it generates."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from ...source import Span
from .escape import escape_fault
from .interface_file import GrammarProblem

UNIT = re.compile(r"\s*\[([^,\]]+)\]")


@dataclass(frozen=True, slots=True)
class InterfaceComment:
    """The text after the `#` characters of one line, and its offset."""

    text: str
    at: int


def comment_problems(comments: Sequence[InterfaceComment], *, of_field: bool) -> Iterator[GrammarProblem]:
    """Yield what stops the build in the comments that belong to one field, constant or file."""
    found = list(UNIT.finditer("\n".join(comment.text for comment in comments)))
    unit = found[0] if len(found) == 1 else None
    for comment in comments:
        text = comment.text.replace(unit.group(), "") if unit else comment.text
        if escape_fault(text):
            yield backslash(comment)
    if unit and of_field and "\n" in unit.group(1):
        yield GrammarProblem(
            span_of(comments),
            f"rosidl takes `[{unit.group(1).splitlines()[0]}` and the next line for a unit, and generates an .idl "
            "file with a broken string from it; keep what stands in brackets on one line, or use parentheses",
        )
    elif unit and of_field and escape_fault(unit.group(1)):
        yield backslash(next(comment for comment in comments if unit.group(1) in comment.text))


def backslash(comment: InterfaceComment) -> GrammarProblem:
    start, end = escape_fault(comment.text) or (0, len(comment.text))
    escape, span = comment.text[start:end], Span(comment.at + start, comment.at + end)
    message = (
        f"rosidl copies comments into the .idl file and decodes `{escape}` there as an escape: "
        "the build stops with a UnicodeDecodeError or a syntax error; double the backslash, or do without it"
    )
    repaired = comment.text[:start] + "\\" + comment.text[start:]
    left = escape_fault(repaired)
    if left is None or left[0] > end:
        return GrammarProblem(span, message, "\\" + escape, span, "double the backslash")
    return GrammarProblem(span, message)


def span_of(comments: Sequence[InterfaceComment]) -> Span:
    return Span(comments[0].at, comments[-1].at + len(comments[-1].text))

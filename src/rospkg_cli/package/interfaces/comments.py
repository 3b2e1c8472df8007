"""Comments of an interface file: rosidl copies them, and a unit like `[m/s]`, into the .idl file it generates."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import NamedTuple

from ...light_dataclasses import dataclass, replace
from ...source import Span
from .escape import escape_fault
from .grammar_problem import GrammarCode, GrammarProblem


@dataclass(frozen=True, slots=True)
class InterfaceComment:
    """The text after the `#` characters of one line, and its offset."""

    text: str
    at: int


class CommentUnit(NamedTuple):
    """A unit in brackets, as rosidl finds it by `\\s*\\[([^,\\]]+)\\]`."""

    whole: str
    """With the brackets and the blanks before them."""
    inside: str


def units_in(text: str) -> Iterator[CommentUnit]:
    """Yield the units of a comment, in one pass: the expression reads on to the end from each `[`."""
    for piece in text.split("]")[:-1]:
        before, _, inside = piece.rpartition(",")[2].partition("[")
        if inside:
            yield CommentUnit(f"{before[len(before.rstrip()) :]}[{inside}]", inside)


def comment_problems(comments: Sequence[InterfaceComment], *, of_field: bool) -> Iterator[GrammarProblem]:
    """Yield what stops the build in the comments that belong to one field, constant or file."""
    found = list(units_in("\n".join(comment.text for comment in comments)))
    unit = found[0] if len(found) == 1 else None
    for comment in comments:
        text = comment.text.replace(unit.whole, "") if unit else comment.text
        if escape_fault(text):
            yield backslash(comment)
    if unit and of_field and "\n" in unit.inside:
        yield GrammarProblem(span_of(comments), GrammarCode.UNIT_OVER_LINES, (unit.inside.splitlines()[0],))
    elif unit and of_field and escape_fault(unit.inside):
        yield backslash(next(comment for comment in comments if unit.inside in comment.text))


def backslash(comment: InterfaceComment) -> GrammarProblem:
    start, end = escape_fault(comment.text) or (0, len(comment.text))
    escape, span = comment.text[start:end], Span(comment.at + start, comment.at + end)
    found = GrammarProblem(span, GrammarCode.BACKSLASH_IN_COMMENT, (escape,))
    repaired = comment.text[:start] + "\\" + comment.text[start:]
    left = escape_fault(repaired)
    if left is None or left[0] > end:
        return replace(found, repair="\\" + escape, repair_span=span)
    return found


def span_of(comments: Sequence[InterfaceComment]) -> Span:
    return Span(comments[0].at, comments[-1].at + len(comments[-1].text))

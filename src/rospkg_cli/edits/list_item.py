"""An item at the end of a bracketed list of Python that looks like the ones before it, and can be taken out again.

Other than `python_list`, it never adds a comma behind the last item of a list that has none there.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from ..finding import Edit
from ..source import Source, Span
from .python_list import COMMA, LINE_END, begins_line, indent_of

WIDTH = 99
"""The longest line that ament's linters allow."""


def append_item(source: Source, brackets: Span, items: Sequence[Span], code: str) -> tuple[Edit, ...]:
    """Put an item behind the last one, on a line of its own where that one has one, or where the line is too long."""
    inside = [item for item in items if brackets.start < item.start and item.end < brackets.end]
    if not inside:
        return (first_item(source, brackets, code),)
    last = max(inside, key=lambda item: item.end)
    comma = COMMA.match(source.text, last.end)
    end = comma.end() if comma else last.end
    if begins_line(source, last.start) and (rest := LINE_END.match(source.text, end)):
        line = f"\n{indent_of(source, last.start)}{code}"
        if comma:
            return (Edit(source.path, Span(rest.end(), rest.end()), f"{line},"),)
        if not rest.group().strip():
            return (Edit(source.path, Span(end, end), f",{line}"),)
        return Edit(source.path, Span(end, end), ","), Edit(source.path, Span(rest.end(), rest.end()), line)
    own_line = begins_line(source, last.start) or not fits(source, end, code)
    glue = f"\n{' ' * column_of(source, inside[0].start)}" if own_line else " "
    text = f"{glue}{code}," if comma else f",{glue}{code}"
    return (Edit(source.path, Span(end, end), text),)


def first_item(source: Source, brackets: Span, code: str) -> Edit:
    """Put an item into an empty list: on a line of its own where the brackets are on two, below comments in it."""
    inner = source.text[brackets.start + 1 : brackets.end - 1]
    close = source.line_span(source.position(brackets.end)[0])
    if "\n" not in inner:
        return Edit(source.path, Span(brackets.start + 1, brackets.start + 1), code)
    indent = indent_of(source, close.start + len(source.slice(close)) - len(source.slice(close).lstrip()))
    if begins_line(source, brackets.end - 1):
        return Edit(source.path, Span(close.start, close.start), f"{indent}    {code},\n")
    return Edit(source.path, Span(brackets.end - 1, brackets.end - 1), code)


def fits(source: Source, at: int, code: str) -> bool:
    """Return whether the line is still short enough with an item."""
    line = source.line_span(source.position(at)[0])
    return line.end - line.start + len(code) + 2 <= WIDTH


def column_of(source: Source, at: int) -> int:
    return at - source.line_span(source.position(at)[0]).start


def removals(source: Source, item: Span) -> Iterator[tuple[Edit, ...]]:
    """Yield the ways to take out an item that is the last, the only one, or one among others."""
    text = source.text
    comma = COMMA.match(text, item.end)
    end = comma.end() if comma else item.end
    before = len(text[: item.start].rstrip())
    if comma and begins_line(source, item.start) and text[end : end + 1] == "\n":
        yield (Edit(source.path, Span(source.line_span(source.position(item.start)[0]).start, end + 1), ""),)
    if comma:
        yield (Edit(source.path, Span(before, end), ""),)
    elif text[:before].endswith(","):
        yield (Edit(source.path, Span(before - 1, end), ""),)
    elif (parts := commented_before(source, item)) is not None:
        yield parts
    yield (Edit(source.path, Span(item.start, end), ""),)


def commented_before(source: Source, item: Span) -> tuple[Edit, ...] | None:
    """Return the edits that remove an item without a comma, below a line whose item got one before its comment."""
    line = source.position(item.start)[0]
    if line == 1 or not begins_line(source, item.start):
        return None
    above = source.line_span(line - 1)
    code, sign, _ = source.slice(above).partition("#")
    if not sign or not code.rstrip().endswith(","):
        return None
    comma = above.start + len(code.rstrip()) - 1
    return Edit(source.path, Span(comma, comma + 1), ""), Edit(source.path, Span(above.end, item.end), "")

"""Where the spans of a text are after an edit of it."""

from __future__ import annotations

from itertools import takewhile

from ...finding import Location
from ...light_dataclasses import dataclass, replace
from ...source import Span


@dataclass(frozen=True)
class KeptSpans:
    """The lines that two texts have in common, before and behind what is another one."""

    start: int
    """The offset of the first line that differs."""
    end: int
    """That of the first line behind it which is there in both, in the text before; behind the text where none is."""
    moved: int
    """By how many characters what lies behind has moved."""
    moved_lines: int

    @classmethod
    def between(cls, before: str, now: str) -> KeptSpans:
        old, new = before.split("\n"), now.split("\n")
        first = same(old, new)
        last = same(old[first:][::-1], new[first:][::-1])
        length = sum(len(line) + 1 for line in old[len(old) - last :])
        start = sum(len(line) + 1 for line in old[:first])
        return cls(min(start, len(now)), len(before) + 1 - length, len(now) - len(before), len(new) - len(old))

    def span(self, span: Span) -> Span | None:
        """Return where a span is now; None where its lines are others."""
        if span.end <= self.start:
            return span
        return Span(span.start + self.moved, span.end + self.moved) if span.start >= self.end else None

    def location(self, at: Location) -> Location | None:
        """Return where a place is now; None where its lines are others."""
        span = self.span(at.span)
        if span is None or span == at.span:
            return at if span else None
        lines = self.moved_lines
        return replace(at, span=span, line=at.line + lines, end_line=at.end_line + lines)


def same(one: list[str], other: list[str]) -> int:
    """Return how many lines two texts begin with in common."""
    return sum(1 for _ in takewhile(lambda pair: pair[0] == pair[1], zip(one, other, strict=False)))

"""A file's text, with conversion between offsets and lines and columns."""

from __future__ import annotations

from bisect import bisect_right
from functools import cached_property

from .light_dataclasses import dataclass


@dataclass(frozen=True, slots=True, order=True)
class Span:
    """A half-open range of characters, counted from 0 in the decoded text."""

    start: int
    end: int

    def holds(self, other: Span) -> bool:
        """Return whether another span begins in this one."""
        return self.start <= other.start < self.end

    def contains(self, other: Span) -> bool:
        """Return whether another span lies in this one as a whole."""
        return self.start <= other.start and other.end <= self.end


@dataclass(frozen=True)
class Source:
    """The decoded text of one file; `path` is relative to its package, always with `/`."""

    path: str
    text: str

    @cached_property
    def line_starts(self) -> list[int]:
        starts, at = [0], self.text.find("\n")
        while at >= 0:
            starts.append(at + 1)
            at = self.text.find("\n", at + 1)
        return starts

    def position(self, offset: int) -> tuple[int, int]:
        """Return the line and the column of an offset, both from 1, in code points."""
        line = bisect_right(self.line_starts, offset)
        return line, offset - self.line_starts[line - 1] + 1

    def offset(self, line: int, column: int) -> int:
        """Return the offset of a line and a column (both from 1), within the text."""
        line = max(1, min(line, len(self.line_starts)))
        return min(self.line_starts[line - 1] + max(column, 1) - 1, len(self.text))

    def line_span(self, line: int) -> Span:
        """Return the span of a line (from 1) without its end."""
        start = self.line_starts[line - 1]
        end = self.line_starts[line] - 1 if line < len(self.line_starts) else len(self.text)
        return Span(start, max(start, end))

    def slice(self, span: Span) -> str:
        return self.text[span.start : span.end]

"""A value and where it is written."""

from __future__ import annotations

from dataclasses import dataclass

from ..source import Span


@dataclass(frozen=True, slots=True)
class LocatedText:
    text: str
    span: Span
    """Between the quotes where there are any."""
    exact: bool = True
    """Whether each character of the text is one of the span: no reference, no escape."""

    def part(self, start: int, end: int) -> Span:
        """Return the span of some characters of the text."""
        return Span(self.span.start + start, self.span.start + end) if self.exact else self.span

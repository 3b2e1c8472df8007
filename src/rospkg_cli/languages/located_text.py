"""A text with its position in a file."""

from __future__ import annotations

from ..light_dataclasses import dataclass
from ..source import Span


@dataclass(frozen=True, slots=True)
class LocatedText:
    text: str
    span: Span
    """Without quotes."""
    is_exact: bool = True
    """Whether the text is literally at the span: no reference, no escape."""

    def part(self, start: int, end: int) -> Span:
        """Return the span of some characters of the text."""
        return Span(self.span.start + start, self.span.start + end) if self.is_exact else self.span

"""A text that setup.py or setup.cfg passes to setuptools, and its position."""

from __future__ import annotations

from ...languages.python.evaluate.values import Text
from ...light_dataclasses import dataclass, replace
from ...source import Span


@dataclass(frozen=True, slots=True)
class SetupText:
    path: str
    """setup.py or setup.cfg."""
    text: str
    span: Span
    """Of the expression, or of the value without blanks around it."""
    literal: Span | None = None
    """Where the text is written literally, and may be edited; None where it was computed."""

    @classmethod
    def of(cls, path: str, value: Text) -> SetupText:
        return cls(path, value.text, value.span, value.literal)

    @property
    def shown(self) -> Span:
        """The narrowest span of the text: without its quotes where it is a plain literal."""
        return self.literal or self.span

    def part(self, start: int, end: int) -> SetupText:
        """Return some characters of it; computed texts keep the span of the whole."""
        if self.literal is None:
            return replace(self, text=self.text[start:end])
        span = Span(self.literal.start + start, self.literal.start + end)
        return SetupText(self.path, self.text[start:end], span, span)

    def stripped(self) -> SetupText:
        start = len(self.text) - len(self.text.lstrip())
        return self.part(start, start + len(self.text.strip()))

    def lines(self) -> list[SetupText]:
        """Return the lines that hold something, stripped, without those that are comments."""
        found, at = [], 0
        for line in self.text.splitlines(keepends=True):
            piece = self.part(at, at + len(line.rstrip("\r\n"))).stripped()
            at += len(line)
            if piece.text and not piece.text.startswith(("#", ";")):
                found.append(piece)
        return found

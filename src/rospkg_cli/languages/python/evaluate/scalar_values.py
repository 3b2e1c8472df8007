"""Values that contain no others: each with the span of the expression that made it."""

from __future__ import annotations

from ....light_dataclasses import dataclass
from ....source import Span


@dataclass(frozen=True, slots=True)
class Text:
    span: Span
    text: str
    literal: Span | None = None
    """The span between the quotes, where the file holds the text literally."""
    is_path: bool = False
    """Whether it is a pathlib.Path."""

    def part(self, start: int, end: int) -> Span:
        """Return the span of some characters of the text; the whole span where it is not a literal."""
        if self.literal is None:
            return self.span
        return Span(self.literal.start + start, self.literal.start + end)


@dataclass(frozen=True, slots=True)
class Constant:
    """A number, a truth value, None, bytes or an ellipsis."""

    span: Span
    value: object


@dataclass(frozen=True, slots=True)
class Symbol:
    """Something built in or imported, by its full name: `os.path.join`, `launch_ros.actions.Node`."""

    span: Span
    name: str


@dataclass(slots=True, eq=False)
class OpenedFile:
    """A file of the package that was opened for reading."""

    span: Span
    path: str
    at: int = 0
    """How many of its characters were read."""


@dataclass(frozen=True, slots=True)
class GlobResult:
    """A glob that was evaluated."""

    span: Span
    pattern: str
    """Relative to the folder of the package; as pathlib and glob would be given it."""
    matches: tuple[str, ...]
    is_certain: bool = True


ScalarValue = Text | Constant | Symbol | OpenedFile

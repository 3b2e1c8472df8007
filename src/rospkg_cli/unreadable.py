"""A file that can't be read: what is wrong with it, and where."""

from __future__ import annotations

from .light_dataclasses import dataclass
from .read_problem import ReadProblem
from .source import Span

READABLE = "those that can be read"
"""`Annotated[tuple[Model, ...], READABLE]` in the input of a rule: it is built without the files that are broken."""


@dataclass(frozen=True, slots=True)
class Unreadable:
    path: str
    span: Span
    code: ReadProblem
    details: tuple[str, ...] = ()
    """What the sentence on the problem names."""
    grammar: bool = False
    """The text may be right for a Python newer than the one that runs us."""
    skipped: bool = False
    """The file exists and is not read on purpose: it is too large, or a link that leads out."""
    outside: bool = False
    """It is skipped because it is a link that leads out of the package and its repository."""


class UnreadableError(Exception):
    """Raised by readers; the engine reports it as one finding."""

    def __init__(
        self,
        path: str,
        span: Span,
        code: ReadProblem,
        *details: str,
        grammar: bool = False,
        skipped: bool = False,
        outside: bool = False,
    ) -> None:
        super().__init__(code.name, *details)
        self.unreadable = Unreadable(path, span, code, details, grammar, skipped, outside)

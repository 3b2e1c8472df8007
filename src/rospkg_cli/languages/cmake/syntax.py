"""Commands of a CMake file and their arguments, each with its span."""

from __future__ import annotations

from typing import Literal

from ...light_dataclasses import dataclass
from ...source import Source, Span
from ..syntax_problem import SyntaxProblem

ArgumentKind = Literal["unquoted", "quoted", "bracket", "paren"]


@dataclass(frozen=True, slots=True)
class CommandArgument:
    kind: ArgumentKind
    text: str
    """As written, without quotes or brackets."""
    span: Span
    """With quotes and brackets."""

    @property
    def inner(self) -> Span:
        """The span of `text`."""
        if self.kind == "quoted":
            return Span(self.span.start + 1, self.span.end - 1)
        return self.span


@dataclass(frozen=True, slots=True)
class CommandInvocation:
    name: str
    """In lower case: CMake does not mind the case."""
    name_span: Span
    span: Span
    """From the name to the closing parenthesis."""
    arguments: tuple[CommandArgument, ...]
    inner: Span
    """Between the parentheses."""


@dataclass(frozen=True)
class CMakeSyntax:
    """The commands of a file, in order; after an error, those that can be recognized again."""

    source: Source
    commands: tuple[CommandInvocation, ...]
    comments: tuple[Span, ...]
    problems: tuple[SyntaxProblem, ...]

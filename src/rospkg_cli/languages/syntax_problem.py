"""A syntax error with its position: one type for all languages."""

from __future__ import annotations

from ..light_dataclasses import dataclass
from ..read_problem import ReadProblem
from ..source import Span


@dataclass(frozen=True, slots=True)
class SyntaxProblem:
    """An error that the language's own parser would report too; offsets are those of the parsed text."""

    span: Span
    code: ReadProblem
    details: tuple[str, ...] = ()


class SyntaxProblemError(ValueError):
    """Raised by parsers that stop at the first problem."""

    def __init__(self, problem: SyntaxProblem) -> None:
        super().__init__(problem.code.name, *problem.details)
        self.problem = problem

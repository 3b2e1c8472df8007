"""The syntax of conditions of package.xml (REP-149): comparisons of strings, `and`, `or`, parentheses."""

from __future__ import annotations

import operator
from collections.abc import Callable, Iterator, Mapping
from functools import lru_cache

from ..lazy_regex import regex
from ..light_dataclasses import dataclass
from ..read_problem import ReadProblem
from ..source import Span
from .syntax_problem import SyntaxProblem, SyntaxProblemError

TOKEN = regex(
    r"""\s*(?:(?P<paren>[()])|(?P<op>==|!=|<=|>=|<|>)|(?P<word>and|or)(?![A-Za-z0-9_-])"""
    r"""|(?P<variable>\$[A-Za-z0-9_]+)|(?P<quoted>"[^"]*"|'[^']*')|(?P<literal>[A-Za-z0-9_-]+))\s*"""
)
OPERATORS: Mapping[str, Callable[[str, str], bool]] = {
    "==": operator.eq,
    "!=": operator.ne,
    "<": operator.lt,
    "<=": operator.le,
    ">": operator.gt,
    ">=": operator.ge,
}


@dataclass(frozen=True, slots=True)
class Operand:
    """A literal or a `$variable`; `text` without quotes and `$`."""

    text: str
    is_variable: bool
    is_quoted: bool
    at: int

    def value(self, variables: Mapping[str, str]) -> str | None:
        """Return the text; of a variable its value, None where that is unknown."""
        return variables.get(self.text) if self.is_variable else self.text


@dataclass(frozen=True, slots=True)
class Comparison:
    left: Operand
    operator: str
    right: Operand

    def holds(self, variables: Mapping[str, str]) -> bool | None:
        left, right = self.left.value(variables), self.right.value(variables)
        if left is None or right is None:
            return None
        return OPERATORS[self.operator](left, right)

    def comparisons(self) -> Iterator[Comparison]:
        yield self


@dataclass(frozen=True, slots=True)
class Junction:
    """Parts joined by `and` or by `or`."""

    word: str
    parts: tuple[Comparison | Junction, ...]

    def holds(self, variables: Mapping[str, str]) -> bool | None:
        found = [part.holds(variables) for part in self.parts]
        decides = self.word == "or"
        if decides in found:
            return decides
        return None if None in found else not decides

    def comparisons(self) -> Iterator[Comparison]:
        for part in self.parts:
            yield from part.comparisons()


Condition = Comparison | Junction

MAX_DEPTH = 50
"""Of parentheses."""


@lru_cache(maxsize=512)
def parse_condition(text: str) -> Condition:
    """Parse a condition; raises SyntaxProblemError."""
    parser = ConditionParser(text)
    found = parser.junction("or")
    if parser.kind:
        raise parser.error(ReadProblem.CONDITION_TOKEN, parser.at, parser.token)
    return found


class ConditionParser:
    def __init__(self, text: str) -> None:
        self.text, self.at, self.end, self.depth = text, 0, 0, 0
        self.kind = self.token = ""
        self.step()

    def step(self) -> None:
        self.at = self.end
        match = TOKEN.match(self.text, self.end)
        if match is None:
            rest = self.text[self.end :]
            if rest.strip():
                first = rest.split()[0]
                raise self.error(ReadProblem.CONDITION_TOKEN, self.end + len(rest) - len(rest.lstrip()), first)
            self.kind = self.token = ""
            return
        self.kind = match.lastgroup or ""
        self.token, self.at, self.end = match.group(self.kind), match.start(self.kind), match.end()

    def error(self, code: ReadProblem, at: int, token: str = "") -> SyntaxProblemError:
        """Return what to raise for a token, or a place where one is missing."""
        return SyntaxProblemError(SyntaxProblem(Span(at, at + len(token)), code, (token,)))

    def junction(self, word: str) -> Condition:
        parts = [self.part(word)]
        while (self.kind, self.token) == ("word", word):
            self.step()
            parts.append(self.part(word))
        return parts[0] if len(parts) == 1 else Junction(word, tuple(parts))

    def part(self, word: str) -> Condition:
        if word == "or":
            return self.junction("and")
        if self.token != "(" or self.kind != "paren":
            return self.comparison()
        self.depth += 1
        if self.depth > MAX_DEPTH:
            raise SyntaxProblemError(
                SyntaxProblem(Span(self.at, self.at), ReadProblem.CONDITION_DEPTH, (str(MAX_DEPTH),))
            )
        self.step()
        found = self.junction("or")
        if (self.kind, self.token) != ("paren", ")"):
            raise self.error(ReadProblem.CONDITION_PARENTHESIS, self.at)
        self.depth -= 1
        self.step()
        return found

    def comparison(self) -> Comparison:
        left = self.operand()
        if self.kind != "op":
            raise self.error(ReadProblem.CONDITION_COMPARISON, self.at)
        sign = self.token
        self.step()
        return Comparison(left, sign, self.operand())

    def operand(self) -> Operand:
        if self.kind not in ("variable", "quoted", "literal", "word"):  # `and` is a value where one is wanted
            raise self.error(ReadProblem.CONDITION_VALUE, self.at)
        text = {"variable": self.token[1:], "quoted": self.token[1:-1]}.get(self.kind, self.token)
        found = Operand(text, self.kind == "variable", self.kind == "quoted", self.at)
        self.step()
        return found

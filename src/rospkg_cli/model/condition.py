"""Conditions of package.xml, by the grammar of REP-149: comparisons of strings, `and`, `or`, parentheses."""

from __future__ import annotations

import operator
import re
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass

TOKEN = re.compile(
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


class ConditionError(ValueError):
    """The text is not a condition; `at` is the offset where it stops being one."""

    def __init__(self, message: str, at: int) -> None:
        super().__init__(message)
        self.at = at


@dataclass(frozen=True, slots=True)
class Operand:
    """A literal or a `$variable`; `text` without quotes and `$`."""

    text: str
    variable: bool
    quoted: bool
    at: int

    def value(self, variables: Mapping[str, str]) -> str:
        return variables.get(self.text, "") if self.variable else self.text


@dataclass(frozen=True, slots=True)
class Comparison:
    left: Operand
    operator: str
    right: Operand

    def holds(self, variables: Mapping[str, str]) -> bool:
        return OPERATORS[self.operator](self.left.value(variables), self.right.value(variables))

    def comparisons(self) -> Iterator[Comparison]:
        yield self


@dataclass(frozen=True, slots=True)
class Junction:
    """Parts joined by `and` or by `or`."""

    word: str
    parts: tuple[Comparison | Junction, ...]

    def holds(self, variables: Mapping[str, str]) -> bool:
        return (all if self.word == "and" else any)(part.holds(variables) for part in self.parts)

    def comparisons(self) -> Iterator[Comparison]:
        for part in self.parts:
            yield from part.comparisons()


Condition = Comparison | Junction


def parse_condition(text: str) -> Condition:
    """Parse a condition; raises ConditionError."""
    parser = Parser(text)
    found = parser.junction("or")
    if parser.kind:
        raise ConditionError(f"`{parser.token}` is not expected", parser.at)
    return found


class Parser:
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
                raise ConditionError(f"`{rest.split()[0]}` is not expected", self.end + len(rest) - len(rest.lstrip()))
            self.kind = self.token = ""
            return
        self.kind = match.lastgroup or ""
        self.token, self.at, self.end = match.group(self.kind), match.start(self.kind), match.end()

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
        if self.depth > 50:
            raise ConditionError("more than 50 parentheses", self.at)
        self.step()
        found = self.junction("or")
        if (self.kind, self.token) != ("paren", ")"):
            raise ConditionError("`)` is missing", self.at)
        self.depth -= 1
        self.step()
        return found

    def comparison(self) -> Comparison:
        left = self.operand()
        if self.kind != "op":
            raise ConditionError("a comparison (`==`, `!=`, `<`, `<=`, `>`, `>=`) is missing", self.at)
        sign = self.token
        self.step()
        return Comparison(left, sign, self.operand())

    def operand(self) -> Operand:
        if self.kind not in ("variable", "quoted", "literal"):
            raise ConditionError("a `$VARIABLE` or a value is missing", self.at)
        text = self.token[1:] if self.kind == "variable" else self.token.strip("\"'")
        found = Operand(text, self.kind == "variable", self.kind == "quoted", self.at)
        self.step()
        return found

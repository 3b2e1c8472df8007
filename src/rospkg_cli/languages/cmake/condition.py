"""Conditions of `if` and `while`: true, false, or unknown."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Protocol

from ...light_dataclasses import dataclass
from .comparisons import BINARY, compare, list_contains
from .list_text import list_to_text
from .regex import max_steps
from .truth import Truth, and_, as_constant, not_, or_
from .values import UNKNOWN, Value, Word

UNARY = frozenset({"EXISTS", "COMMAND", "DEFINED", "TARGET", "POLICY", "TEST", "IS_DIRECTORY", "IS_ABSOLUTE",
                   "IS_SYMLINK", "IS_READABLE", "IS_WRITABLE", "IS_EXECUTABLE"})  # fmt: skip


class ConditionContext(Protocol):
    """What a condition can test."""

    def variable(self, name: str) -> Value | None:
        """Return a variable's value; None where it is not set, UNKNOWN where that is unknown."""

    def operand(self, name: str) -> Value | None:
        """Return the value of a word in a comparison; None where it is literal."""

    def holds(self, test: str, name: str) -> Truth:
        """Evaluate a unary test: EXISTS, COMMAND, TARGET and others."""

    def spend(self, cost: int) -> None:
        """Charge the cost of a comparison."""


def evaluate(words: Sequence[Word], world: ConditionContext) -> Truth:
    """Return whether a condition holds; unknown too where CMake would refuse it."""
    return ConditionReader(words, world).whole()


@dataclass
class ConditionReader:
    words: Sequence[Word]
    world: ConditionContext
    at: int = 0

    def whole(self) -> Truth:
        try:
            found = self.disjunction()
        except (IndexError, RecursionError):
            return None
        return found if self.at == len(self.words) else None

    def peek(self) -> str:
        """Return the next word where it can be a keyword."""
        word = self.words[self.at] if self.at < len(self.words) else None
        return word.text if word is not None and not word.quoted else ""

    def take(self) -> Word:
        self.at += 1
        return self.words[self.at - 1]

    def disjunction(self) -> Truth:
        found = self.conjunction()
        while self.peek() == "OR":
            self.take()
            found = or_(found, self.conjunction())
        return found

    def conjunction(self) -> Truth:
        found = self.negation()
        while self.peek() == "AND":
            self.take()
            found = and_(found, self.negation())
        return found

    def negation(self) -> Truth:
        if self.peek() == "NOT":
            self.take()
            return not_(self.negation())
        return self.test()

    def test(self) -> Truth:
        if self.peek() == "(":
            self.take()
            found = self.disjunction()
            return found if self.take().text == ")" else None
        if self.peek() in UNARY and self.at + 1 < len(self.words):
            test, name = self.take().text, self.take()
            return None if name.maybe or UNKNOWN in name.text else self.world.holds(test, name.text)
        left = self.take()
        if self.peek() in BINARY and self.at + 1 < len(self.words):
            return self.comparison(left, self.take().text, self.take())
        return self.truth(left)

    def comparison(self, left: Word, operator: str, right: Word) -> Truth:
        a, b = self.content(left), self.content(right)
        if operator == "IN_LIST":
            value = self.world.variable(right.text)
            return None if UNKNOWN in a else list_contains(value or (), a)
        if operator == "MATCHES":
            b = right.text
        if UNKNOWN in a or UNKNOWN in b:
            return None
        if operator == "MATCHES":
            self.world.spend(max_steps(b, a) >> 6)
        return compare(operator, a, b)

    def content(self, word: Word) -> str:
        """Return a word, or what the variable of that name holds."""
        if word.maybe:
            return UNKNOWN
        value = None if word.quoted or UNKNOWN in word.text else self.world.operand(word.text)
        return word.text if value is None else list_to_text(value)

    def truth(self, word: Word) -> Truth:
        if word.maybe or UNKNOWN in word.text:
            return None
        if (constant := as_constant(word.text)) is not None:
            return constant
        if word.quoted:
            return False
        value = self.world.variable(word.text)
        if value is None:
            return False
        text = list_to_text(value)
        return None if UNKNOWN in text else as_constant(text) is not False

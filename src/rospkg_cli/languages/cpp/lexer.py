"""Tokens of a C++ text: preprocessor lines, strings with `::`, and names that may be a call of interest.

Comments and code between `#if 0` and its end are left out. One pass of one pattern, as a text has thousands of tokens
that are not needed; names are found by their words and put between the others.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Literal

from ...lazy_regex import regex
from ...light_dataclasses import dataclass, field

Kind = Literal["directive", "string", "name"]

REST = r"[^\n\\/]*(?:(?:/(?![/*])|\\[\s\S])[^\n\\/]*)*"
TOKEN = regex(
    r"""//[^\n\\]*(?:\\[\s\S][^\n\\]*)*|/\*[\s\S]*?(?:\*/|\Z)"""
    r"""|R"([^()\\\s"]{0,16})\([\s\S]*?\)\1\""""
    r"""|"[^"\\\n]*(?:\\[\s\S][^"\\\n]*)*\""""
    r"""|'(?<![0-9A-Za-z_]')(?:[^'\\\n]|\\.)+'"""
    rf"""|\#[ \t]*(?:include|if|ifdef|ifndef|elif|else|endif|define)\b{REST}"""
)
"""A comment, a raw string, a string, a character, a directive. Each begins with a literal, so that `re` skips ahead."""

NAME = regex(
    r"(?:[A-Z][A-Z0-9]*_[A-Z0-9_]+|ClassLoader|\w*declare_parameter\w*|declare_or_get_parameter|declareParameter|get_parameter(?:_or)?)"
    r"(?=\s*([<(]))"
)
WORDS = ("REGISTER", "EXPORT", "ClassLoader", "declare_parameter", "declareParameter", "get_parameter")
"""Each name of interest has one of them."""

DIRECTIVE = regex(r"#[ \t]*(\w+)[ \t]*")
NEVER = regex(r"0\b|false\b")
DEFINE = regex(r"\s*#[ \t]*define[ \t]+")
EDGE = regex(r"\b")


@dataclass(frozen=True, slots=True)
class CppToken:
    """A piece of the text, and the offset of its argument.

    That is a directive's rest (`word` is its name), or the parenthesis or `<` behind a name.
    """

    kind: Kind
    start: int
    end: int
    is_conditional: bool
    """Whether it is inside an `#if` other than a header's include guard."""
    word: str = ""
    at: int = 0


@dataclass(slots=True)
class ConditionalBlock:
    """One open `#if`."""

    guard: bool
    dead: bool


@dataclass
class ConditionalStack:
    """The `#if`s that are open."""

    levels: list[ConditionalBlock] = field(default_factory=list)
    first: bool = True

    @property
    def dead(self) -> bool:
        return any(level.dead for level in self.levels)

    @property
    def conditional(self) -> bool:
        return any(not level.guard for level in self.levels)

    def step(self, word: str, text: str, start: int, end: int) -> None:
        """Process one directive, whose arguments begin at `start`."""
        if word in ("if", "ifdef", "ifndef"):
            guard = word == "ifndef" and self.first and guards(text, start, end)
            self.levels.append(ConditionalBlock(guard, word == "if" and NEVER.match(text, start) is not None))
        elif word in ("else", "elif") and self.levels:
            self.levels[-1].dead = False
        elif word == "endif" and self.levels:
            self.levels.pop()
        self.first = False


def guards(text: str, start: int, end: int) -> bool:
    """Return whether the name behind `#ifndef` is defined in the next directive."""
    name, found = text[start:end].strip(), DEFINE.match(text, end)
    return found is not None and text.startswith(name, found.end()) and bool(EDGE.match(text, found.end() + len(name)))


def names(text: str, at: int) -> list[tuple[int, int, int]]:
    """Return where each name of interest begins and ends, and the bracket behind it, in order, also in comments."""
    found = {}
    for word in WORDS:
        place = text.find(word, at)
        while place >= 0:
            start = place
            while start > at and (text[start - 1].isalnum() or text[start - 1] == "_"):
                start -= 1
            if start not in found and (match := NAME.match(text, start)):
                found[start] = (start, match.end(), match.start(1))
            place = text.find(word, place + len(word))
    return [found[start] for start in sorted(found)]


def tokens(text: str, at: int = 0) -> Iterator[CppToken]:
    """Yield the tokens from an offset on, in order."""
    conditions, waiting = ConditionalStack(), names(text, at)[::-1]
    dead = is_conditional = False
    for match in TOKEN.finditer(text, at):
        start, end = match.span()
        while waiting and waiting[-1][0] < start:
            begin, close, opening = waiting.pop()
            if not dead:
                yield CppToken("name", begin, close, is_conditional, at=opening)
        while waiting and waiting[-1][0] < end:
            waiting.pop()
        sign = text[start]
        if sign == "#":
            found = DIRECTIVE.match(text, start)
            assert found is not None
            word, behind = found[1], found.end()
            if word not in ("include", "define"):
                conditions.step(word, text, behind, end)
                dead, is_conditional = conditions.dead, conditions.conditional
                continue
            conditions.first = False
            if not dead:
                yield CppToken("directive", start, end, is_conditional, word, behind)
        elif sign == '"' and not dead and "::" in match[0]:
            yield CppToken("string", start, end, is_conditional)
    for begin, close, opening in reversed(waiting):
        if not dead:
            yield CppToken("name", begin, close, is_conditional, at=opening)

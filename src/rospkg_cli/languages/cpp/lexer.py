"""Tokens of a C++ text: preprocessor lines, strings, and names that may be a call of interest.

Comments and code between `#if 0` and its end are left out. One pass of one pattern, as a text has
thousands of tokens that are not needed.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import Literal

from ...lazy_regex import regex
from ...light_dataclasses import dataclass, field

Kind = Literal["directive", "string", "name"]

REST = r"(?:[^\n\\/]|/(?![/*])|\\[\s\S])*"
TOKEN = regex(
    r"""(?P<comment>//[^\n\\]*(?:\\[\s\S][^\n\\]*)*|/\*[\s\S]*?(?:\*/|\Z))"""
    r"""|(?P<raw>R"(?P<tag>[^()\\\s"]{0,16})\([\s\S]*?\)(?P=tag)")"""
    r"""|(?P<string>"(?:[^"\\\n]|\\[\s\S])*")"""
    r"""|(?P<char>(?<![0-9A-Za-z_])'(?:[^'\\\n]|\\.)+')"""
    rf"""|(?P<directive>\#[ \t]*(?:include|if|ifdef|ifndef|elif|else|endif|define)\b{REST})"""
    r"""|(?P<name>\b(?:[A-Z][A-Z0-9]*_[A-Z0-9_]+|ClassLoader|\w*declare_parameter\w*|declare_or_get_parameter|get_parameter(?:_or)?)(?=\s*(?P<opening>[<(])))"""
)
DIRECTIVE = regex(r"#[ \t]*(\w+)[ \t]*")
NEVER = regex(r"0\b|false\b")


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
    name = text[start:end].strip()
    return re.compile(rf"\s*#[ \t]*define[ \t]+{re.escape(name)}\b").match(text, end) is not None


def tokens(text: str, at: int = 0) -> Iterator[CppToken]:
    """Yield the tokens from an offset on, in order."""
    conditions = ConditionalStack()
    for match in TOKEN.finditer(text, at):
        kind = match.lastgroup
        if kind == "directive":
            found = DIRECTIVE.match(text, match.start())
            assert found is not None
            word, start = found.group(1), found.end()
            if not conditions.dead and word in ("include", "define"):
                yield CppToken("directive", match.start(), match.end(), conditions.conditional, word, start)
            conditions.step(word, text, start, match.end())
        elif kind == "string" and not conditions.dead:
            yield CppToken("string", match.start(), match.end(), conditions.conditional)
        elif kind == "name" and not conditions.dead:
            yield CppToken("name", match.start(), match.end(), conditions.conditional, at=match.start("opening"))

"""Split a CMake text into tokens that cover all of it, also where it is not valid.

The patterns are those of CMake's own lexer (Source/LexerParser/cmListFileLexer.in.l); where two of them fit, the
longer one wins, as there.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import Literal

from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...source import Span

Kind = Literal[
    "space", "newline", "comment", "bracket comment", "(", ")", "identifier", "unquoted", "quoted", "bracket", "bad"
]

BARE = r"""(?:[^ \0\t\r\n()#"\\]|\\[^\0\n])"""
MAKE = r"(?:\$\([A-Za-z0-9_]*\))"
LEGACY = rf"""(?:{MAKE}|{BARE}|"(?:{MAKE}|{BARE}|[ \t])*")"""
"""`-Da="b c"` and `$(MAKE)`: quotes and parentheses inside an unquoted argument."""

TOKEN = regex(
    r"""(?P<newline>\n)"""
    r"""|(?P<space>[ \t\r]+)"""
    r"""|(?P<open>\#?\[=*\[)"""
    r"""|(?P<comment>\#[^\n]*)"""
    r"""|(?P<paren>[()])"""
    rf"""|(?P<unquoted>(?:{MAKE}|{BARE}){LEGACY}*)"""
    r"""|(?P<quoted>"[^"\\]*(?:\\.[^"\\]*)*")""",
    re.DOTALL,
)


@dataclass(frozen=True, slots=True)
class CMakeToken:
    kind: Kind
    text: str
    start: int

    @property
    def end(self) -> int:
        return self.start + len(self.text)

    @property
    def span(self) -> Span:
        return Span(self.start, self.end)


def tokens(text: str, at: int = 0) -> Iterator[CMakeToken]:
    """Yield the tokens of a text from an offset on.

    A string or a bracket that is never closed is one `bad` token up to the end; so is an unexpected character.
    """
    length, match_at = len(text), TOKEN.match
    while at < length:
        match = match_at(text, at)
        if match is None:
            token = CMakeToken("bad", text[at:] if text[at] == '"' else text[at], at)
        elif (kind := match.lastgroup) == "open":
            token = bracket_token(text, at, match[0])
        else:
            token = CMakeToken(kind_of(kind, match[0]), match[0], at)
        yield token
        at += len(token.text)


def kind_of(group: str | None, found: str) -> Kind:
    """Return the kind of a token by the group of the pattern that fits."""
    match group:
        case "newline" | "space" | "comment" | "quoted" as kind:
            return kind
        case "paren":
            return "(" if found == "(" else ")"
        case _:
            return "identifier" if found.isidentifier() and found.isascii() else "unquoted"


def bracket_token(text: str, at: int, opening: str) -> CMakeToken:
    """Return a bracket argument or comment; `#[[` without an end swallows the rest, as it does in CMake."""
    closing = "]" + "=" * opening.count("=") + "]"
    end = text.find(closing, at + len(opening))
    if end < 0:
        return CMakeToken("bad", text[at:], at)
    whole = text[at : end + len(closing)]
    return CMakeToken("bracket comment" if opening.startswith("#") else "bracket", whole, at)

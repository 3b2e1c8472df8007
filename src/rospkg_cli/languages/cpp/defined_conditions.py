"""Which places of a C++ text are compiled wherever some macros are defined."""

from __future__ import annotations

from collections.abc import Collection

from ...lazy_regex import regex
from .lexer import DIRECTIVE, TOKEN, ConditionalStack

ASKED = regex(r"(?:defined[ \t]*\(?[ \t]*)?(\w+)[ \t]*\)?\s*(?://.*|/\*.*)?")
"""What `#ifdef` and an `#if` of one macro have behind them."""


def is_under_defined(text: str, offset: int, macros: Collection[str]) -> bool:
    """Return whether each `#if` around an offset asks for a given macro.

    The include guard of a header counts for nothing.
    """
    open_ones: list[bool] = []
    stack = ConditionalStack()
    for match in TOKEN.finditer(text, 0, offset):
        start, end = match.span()
        found = DIRECTIVE.match(text, start) if text[start] == "#" else None
        if found is None:
            continue
        word = found[1]
        stack.step(word, text, found.end(), end)
        if word in ("if", "ifdef", "ifndef"):
            asked = ASKED.fullmatch(text, found.end(), end)
            is_asked = word != "ifndef" and asked is not None and asked[1] in macros
            open_ones.append(is_asked or stack.levels[-1].guard)
        elif word in ("else", "elif") and open_ones:
            open_ones[-1] = False
        elif word == "endif" and open_ones:
            open_ones.pop()
    return all(open_ones)

"""Which macros the `#if`s around a place of C++ ask for: without them it is not compiled."""

from __future__ import annotations

from ...lazy_regex import regex
from .lexer import DIRECTIVE, NEVER, TOKEN

NEVER_DEFINED = "0"
"""Stands for the condition of `#if 0`."""
DEFINED = regex(r"(?:defined[ \t]*\(?[ \t]*)?([A-Za-z_]\w*)[ \t]*\)?")
REMARK = regex(r"//.*|/\*.*")


def asked_macros(text: str, at: int) -> frozenset[str]:
    """Return the macros that must be defined where a place is compiled, as far as the conditions are plain."""
    opened: list[frozenset[str]] = []
    for match in TOKEN.finditer(text, 0, at):
        found = DIRECTIVE.match(match[0]) if match[0][0] == "#" else None
        word = found[1] if found is not None else ""
        if word in ("if", "ifdef", "ifndef"):
            opened.append(asked_by(word, match[0][found.end() :] if found is not None else ""))
        elif word in ("else", "elif") and opened:
            opened[-1] = frozenset()
        elif word == "endif" and opened:
            opened.pop()
    return frozenset().union(*opened)


def asked_by(word: str, condition: str) -> frozenset[str]:
    """Return the macros without which a condition does not hold: `X`, `defined(X) && defined(Y)`."""
    condition = REMARK.sub("", condition).strip()
    if word == "if" and NEVER.match(condition):
        return frozenset({NEVER_DEFINED})
    parts = [DEFINED.fullmatch(each.strip()) for each in condition.split("&&")]
    return frozenset(each[1] for each in parts if each is not None) if word != "ifndef" and all(parts) else frozenset()

"""Messages for syntax errors of CMake files."""

from __future__ import annotations

from ...lazy_regex import regex
from .lexer import CMakeToken

CONFLICT = regex(r"(<{7}|={7}|>{7}|\|{7})(?![^ \n])")


def unexpected(token: CMakeToken, fresh: bool) -> str:
    if CONFLICT.match(token.text):
        return f"`{token.text[:7]}` is left from a merge conflict"
    if token.kind == "bad" and len(token.text) > 1:
        return unclosed(token)
    if not fresh:
        return f"`{token.text}` follows a command in the same line: CMake wants a new line for each command"
    if token.kind == ")":
        return "`)` closes nothing"
    return f"`{token.text}` is where a command should begin"


def unclosed(token: CMakeToken) -> str:
    match token.text[:1]:
        case '"':
            return '`"` is never closed'
        case "[" | "#":
            opening = token.text[: token.text.index("[", token.text.index("[") + 1) + 1]
            return f"`{opening}` is never closed"
        case _:
            return f"`{token.text}` is not a character that CMake allows here"

"""What is wrong where a CMake file has a syntax error."""

from __future__ import annotations

from ...lazy_regex import regex
from ...read_problem import ReadProblem
from .lexer import CMakeToken

CONFLICT = regex(r"(<{7}|={7}|>{7}|\|{7})(?![^ \n])")

CONFLICT_START = "<" * 7
"""The first word of a conflict's first line: among arguments it would be one of them."""

Found = tuple[ReadProblem, str]
"""A problem and its detail."""


def unexpected(token: CMakeToken, fresh: bool) -> Found:
    if CONFLICT.match(token.text):
        return ReadProblem.CMAKE_CONFLICT, token.text[:7]
    if token.kind == "bad" and len(token.text) > 1:
        return unclosed(token)
    if not fresh:
        return ReadProblem.CMAKE_SAME_LINE, token.text
    if token.kind == ")":
        return ReadProblem.CMAKE_CLOSES_NOTHING, token.text
    return ReadProblem.CMAKE_NO_COMMAND, token.text


def unclosed(token: CMakeToken) -> Found:
    match token.text[:1]:
        case '"':
            return ReadProblem.CMAKE_OPEN_QUOTE, token.text[0]
        case "[" | "#":
            opening = token.text[: token.text.index("[", token.text.index("[") + 1) + 1]
            return ReadProblem.CMAKE_OPEN_BRACKET, opening
        case _:
            return ReadProblem.CMAKE_CHARACTER, token.text

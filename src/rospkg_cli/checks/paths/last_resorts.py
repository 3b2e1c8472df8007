"""Paths that code tries only where something else failed before: what it wants is looked up another way first."""

from __future__ import annotations

import ast

from ...languages.cpp.lexer import TOKEN
from ...languages.python.file import PythonFile
from ...languages.python.nodes import nodes_of_kind
from ...lazy_regex import regex
from ...source import Span
from .home_path_texts import CPP, is_in_handler

BRACE = regex(r"[{}]")
CATCH = regex(r"\bcatch\s*\((?:[^()]|\([^()]*\))*\)\s*\Z")
CHOICE = regex(r"\bvalue_or\s*\(|\?")
SHARE = regex(r"(?i)share(?!d)")
"""What a look-up of the share directory, or a variable for it, is called: `get_package_share_directory`."""
MOST = 400
"""How many characters before a brace, or in a statement before a place, are looked at."""


def is_last_resort(path: str, bare: str, place: Span, file: PythonFile | None) -> bool:
    """Return whether a path is in what handles an exception, or stands in for a share directory that is not found.

    Args:
        bare: the text of the file, without its comments.
    """
    if path.endswith(CPP):
        return is_in_catch(bare, place.start) or is_chosen(bare, place.start)
    if not path.endswith(".py"):
        return False
    return is_in_handler(bare, place.start) or (file is not None and is_other_choice(file, place))


def is_in_catch(code: str, at: int) -> bool:
    """Return whether a place in C++ is in a block of `catch`."""
    if "catch" not in code[:at]:
        return False
    code, opened = TOKEN.sub(lambda match: " " * len(match[0]), code), list[int]()
    for found in BRACE.finditer(code, 0, at):
        if found[0] == "{":
            opened.append(found.start())
        elif opened:
            opened.pop()
    return any(CATCH.search(code[max(0, brace - MOST) : brace]) for brace in opened)


def is_chosen(code: str, at: int) -> bool:
    """Return whether the statement around a place in C++ takes it where a look-up of a share directory gave nothing."""
    statement = code[max(0, at - MOST, *(code.rfind(end, 0, at) for end in ";{}")) : at]
    return CHOICE.search(statement) is not None and SHARE.search(statement) is not None


def is_other_choice(file: PythonFile, place: Span) -> bool:
    """Return whether a place in Python is behind the `or` or the `else` of a look-up of a share directory."""
    for each in nodes_of_kind(file.tree, ast.BoolOp):
        later = [part for part in each.values[1:] if file.span(part).holds(place)]
        if isinstance(each.op, ast.Or) and later and SHARE.search(ast.unparse(each.values[0])):
            return True
    choices = (each for each in nodes_of_kind(file.tree, ast.IfExp) if file.span(each.orelse).holds(place))
    return any(SHARE.search(ast.unparse(each.body)) for each in choices)

"""How large a Python file may be: a syntax tree takes a thousand times the memory of its text."""

from __future__ import annotations

import ast
import re

from ...lazy_regex import regex
from .nodes import nodes_below

MAX_TOKENS = 200_000
"""Some 20,000 lines of code; their tree takes up to 300 MiB."""

MAX_DEPTH = 200
"""Nodes inside each other: what visits them recursively takes up to four frames for each, of Python's 1,000."""

LEAVES = frozenset({int, bool, str, type(None), ast.Name, ast.Constant, ast.alias, *ast.expr_context.__subclasses__()})
"""What holds no node that matters for the depth, of the values of a node's fields."""

TOKEN = regex(
    r"\#[^\r\n]*|\"{3}[^\\\"]*(?:(?:\\.|\"(?!\"\"))[^\\\"]*)*\"{3}|'{3}[^\\']*(?:(?:\\.|'(?!''))[^\\']*)*'{3}"
    r"|\"[^\\\"\r\n]*(?:\\.[^\\\"\r\n]*)*\"|'[^\\'\r\n]*(?:\\.[^\\'\r\n]*)*'|\w+|[^\w\s]",
    re.DOTALL,
)


def is_too_large(text: str) -> bool:
    """Return whether a text has more than MAX_TOKENS tokens; costs nothing for a text with fewer characters."""
    if len(text) <= MAX_TOKENS:
        return False
    return any(count >= MAX_TOKENS for count, _ in enumerate(TOKEN.finditer(text)))


def is_too_deep(tree: ast.AST) -> bool:
    """Return whether nodes stand inside each other more than MAX_DEPTH times, without recursion."""
    if nodes_below(tree).levels < MAX_DEPTH - 1:
        return False
    level: list[object] = [tree]
    for _ in range(MAX_DEPTH):
        following: list[object] = []
        for node in level:
            if node.__class__ not in LEAVES:
                for value in node.__dict__.values():
                    if value.__class__ is list:
                        following += value
                    elif value.__class__ not in LEAVES:
                        following.append(value)
        if not following:
            return False
        level = following
    return True

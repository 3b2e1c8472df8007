"""Personal paths for one machine: code checks the account or host first, or another host gets the path."""

from __future__ import annotations

import ast
import re

from ...languages.python.file import PythonFile
from ...languages.python.nodes import nodes_of
from ...lazy_regex import regex
from ...source import Span

ASKED = regex(
    r"\b(?:getuser|getlogin|gethostname|getfqdn|uname|node)\(\)"
    r"|\b(?:environ(?:\.get\(|\[)|getenv\()\s*[\"'](?:USER|USERNAME|LOGNAME|HOSTNAME|HOST|COMPUTERNAME)[\"']"
)
"""How Python gets the account or the machine that it runs on."""
REMOTE = regex(r"(?:(?:^|[\[(,\s])[fFrR]?[\"'](?:\S*/)?(?:ssh|scp|rsync|sshpass)[\"'])(?:[^\]\[\n]|\n(?!\s*\n))*$")
"""The start of a list of words for a command that hands the rest to another machine."""
LONGEST = 400


def is_for_one_machine(file: PythonFile, place: Span) -> bool:
    """Return whether a place is one of several that are chosen by the account or the machine."""
    asked = names_of_machines(file)
    parts: tuple[ast.expr | list[ast.stmt], ...]
    for node in nodes_of(file.tree):
        match node:
            case ast.If() | ast.IfExp():
                test, parts = node.test, (node.body, node.orelse)
            case ast.Subscript(value=value, slice=index):
                test, parts = index, (value,)
            case ast.Call(func=ast.Attribute(value=ast.Dict() as value), args=[index, *_]):
                test, parts = index, (value,)
            case _:
                continue
        if is_asked(file, test, asked) and any(holds(file, part, place) for part in parts):
            return True
    return False


def names_of_machines(file: PythonFile) -> frozenset[str]:
    """Return the variables that hold the account or the machine."""
    bound = (node for node in nodes_of(file.tree) if isinstance(node, ast.Assign))
    asking = (node for node in bound if ASKED.search(file.source.slice(file.span(node.value))))
    return frozenset(each.id for node in asking for each in node.targets if isinstance(each, ast.Name))


def is_asked(file: PythonFile, test: ast.expr, asked: frozenset[str]) -> bool:
    names = {each.id for each in ast.walk(test) if isinstance(each, ast.Name)}
    return bool(names & asked) or ASKED.search(file.source.slice(file.span(test))) is not None


def holds(file: PythonFile, part: ast.AST | list[ast.stmt], place: Span) -> bool:
    nodes = part if isinstance(part, list) else [part]
    return any(file.span(each).holds(place) for each in nodes if isinstance(each, (ast.expr, ast.stmt)))


def is_on_another_host(text: str, place: int) -> bool:
    """Return whether a place is among the words of a command that runs on another host: `['ssh', 'robot', '/…']`."""
    before = re.sub(r"\([^()]*\)", "", text[max(0, place - LONGEST) : place])
    return REMOTE.search(before) is not None

"""Functions of a Python node that run only on request: the callbacks of its services and actions."""

from __future__ import annotations

import ast
from collections.abc import Iterator

from ...languages.python.file import PythonFile
from ...languages.python.nodes import FunctionNode, last_name, nodes_of_kind
from ...source import Span

SERVERS = frozenset({"create_service", "ActionServer", "Service"})


def parts_on_request(file: PythonFile) -> tuple[Span, ...]:
    """Return the functions of a file that it hands to a service or an action, whole."""
    handed = frozenset(names_handed_on(file))
    functions: list[FunctionNode] = [*nodes_of_kind(file.tree, ast.FunctionDef)]
    functions += nodes_of_kind(file.tree, ast.AsyncFunctionDef)
    return tuple(file.span(each) for each in functions if each.name in handed)


def names_handed_on(file: PythonFile) -> Iterator[str]:
    for call in nodes_of_kind(file.tree, ast.Call):
        if last_name(call.func) in SERVERS:
            yield from filter(None, (last_name(value) for value in (*call.args, *(k.value for k in call.keywords))))

"""Statements of functions that only make what nothing reads: branches that bind such values, and lists they go into."""

from __future__ import annotations

import ast
from collections.abc import Iterator, Set

from .file import PythonFile
from .nodes import nodes_below, nodes_of_kind

FILLS = frozenset({"append", "extend", "insert"})
FILLED = ast.List | ast.ListComp
"""What a name is bound to that holds a list of its own."""
ACTS = ast.NamedExpr | ast.Await | ast.Yield | ast.YieldFrom
"""What a condition does in addition to its result."""


def idle_tests(file: PythonFile, lost: Set[int]) -> Iterator[ast.expr]:
    """Yield the conditions of each `if` that only chooses among values whose identities are given."""
    for function in nodes_of_kind(file.tree, ast.FunctionDef):
        for node in nodes_below(function):
            if isinstance(node, ast.If) and id(node.test) not in lost and is_idle(node, lost):
                yield node.test


def is_idle(statement: ast.stmt, lost: Set[int]) -> bool:
    """Return whether a statement does nothing but make values whose identities are given."""
    match statement:
        case ast.Assign(targets=targets, value=value):
            return id(value) in lost and all(isinstance(each, ast.Name) for each in targets)
        case ast.AnnAssign(target=ast.Name(), value=value):
            return value is None or id(value) in lost
        case ast.Expr(value=value):
            return id(value) in lost or isinstance(value, ast.Constant)
        case ast.If(test=test, body=body, orelse=other):
            is_plain = not any(isinstance(each, ACTS) for each in ast.walk(test))
            return is_plain and all(is_idle(each, lost) for each in (*body, *other))
    return isinstance(statement, ast.Pass)


def filling_calls(file: PythonFile) -> Iterator[tuple[ast.Name, ast.Call]]:
    """Yield the statements of functions that put something into a list of a name, with the read of the name.

    The list has that name alone as long as nothing else reads it.
    """
    stored: dict[str, list[ast.expr | None]] = {}
    made = {id(node.targets[0]): node.value for node in nodes_of_kind(file.tree, ast.Assign)}
    for each in nodes_of_kind(file.tree, ast.Name):
        if not isinstance(each.ctx, ast.Load):
            stored.setdefault(each.id, []).append(made.get(id(each)))
    own = {name for name, values in stored.items() if all(isinstance(each, FILLED) for each in values)}
    given = {each.arg for each in nodes_of_kind(file.tree, ast.arg)}
    for function in nodes_of_kind(file.tree, ast.FunctionDef):
        for node in nodes_below(function):
            match node:
                case ast.Expr(value=ast.Call(func=ast.Attribute(value=ast.Name(id=name) as read, attr=word)) as call):
                    if word in FILLS and name in own and name not in given:
                        yield read, call

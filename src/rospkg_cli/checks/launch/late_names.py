"""Local names of a Python launch file that are read above the one line that assigns them."""

from __future__ import annotations

import ast
from collections.abc import Iterator, Mapping

from ...languages.python.file import PythonFile
from ...languages.python.nodes import children_of, nodes_of
from ...light_dataclasses import dataclass
from ...source import Span

SCOPES = (
    ast.FunctionDef, ast.AsyncFunctionDef, ast.Lambda, ast.ClassDef, ast.ListComp, ast.SetComp, ast.DictComp,
    ast.GeneratorExp,
)  # fmt: skip
SIMPLE = (ast.Assign, ast.AnnAssign, ast.AugAssign, ast.Expr, ast.Return)
"""Statements that certainly run, one after the other."""


@dataclass(frozen=True, slots=True)
class LateName:
    name: str
    span: Span
    line: int
    """Of the assignment."""
    function: str


def late_names(file: PythonFile) -> Iterator[LateName]:
    """Yield the first use of each name that stands above its only assignment, in the same straight line."""
    for function in nodes_of(file.tree):
        if isinstance(function, ast.FunctionDef):
            assigned = straight_assignments(function)
            seen: set[str] = set()
            may_be = any(may_be_late(node, assigned) for node in nodes_of(function)) if assigned else False
            last = max(at for at, _ in assigned.values()) if may_be else 0
            for at, statement in enumerate(function.body[:last]):
                for node in own_nodes(statement) if isinstance(statement, SIMPLE) else ():
                    where = assigned.get(node.id, (0, 0)) if isinstance(node, ast.Name) else (0, 0)
                    if isinstance(node, ast.Name) and where[0] > at and node.id not in seen:
                        seen.add(node.id)
                        yield LateName(node.id, file.span(node), where[1], function.name)


def may_be_late(node: ast.AST, assigned: Mapping[str, tuple[int, int]]) -> bool:
    """Return whether a node uses a name above its assignment, or in the same line."""
    if not isinstance(node, ast.Name) or not isinstance(node.ctx, ast.Load) or node.id not in assigned:
        return False
    return node.lineno <= assigned[node.id][1]


def straight_assignments(function: ast.FunctionDef) -> dict[str, tuple[int, int]]:
    """Return the names that one assignment in the body itself binds, and nothing else: its index and its line."""
    bound: dict[str, int] = {}
    for node in nodes_of(function):
        for name in bound_by(node) if node is not function else ():
            bound[name] = bound.get(name, 0) + 1
    found = {}
    for at, statement in enumerate(function.body):
        match statement:
            case ast.Assign(targets=[ast.Name(id=name)]) | ast.AnnAssign(target=ast.Name(id=name), value=ast.expr()):
                if bound[name] == 1:
                    found[name] = at, statement.lineno
    return found


def bound_by(node: ast.AST) -> Iterator[str]:
    match node:
        case ast.Name(id=name) if not isinstance(node.ctx, ast.Load):
            yield name
        case ast.arg(arg=name) | ast.FunctionDef(name=name) | ast.ClassDef(name=name):
            yield name
        case ast.alias(name=name, asname=other):
            yield other or name.partition(".")[0]
        case ast.ExceptHandler(name=str(name)):
            yield name
        case ast.Global(names=names) | ast.Nonlocal(names=names):
            yield from names


def own_nodes(statement: ast.AST) -> Iterator[ast.AST]:
    """Yield the nodes of a statement, but for those that run later or in a scope of their own."""
    waiting = [statement]
    while waiting:
        node = waiting.pop()
        yield node
        waiting += [child for child in reversed(children_of(node)) if not isinstance(child, SCOPES)]

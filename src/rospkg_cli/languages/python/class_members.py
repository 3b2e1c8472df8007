"""The names that the bodies of classes bind, and the attributes that code sets."""

from __future__ import annotations

import ast
from collections.abc import Iterator

from .nodes import FunctionNode, children_of, nodes_of_kind


def attributes_set(tree: ast.AST) -> Iterator[str]:
    grown = {id(each.target) for each in nodes_of_kind(tree, ast.AugAssign)}
    for each in nodes_of_kind(tree, ast.Attribute):
        if isinstance(each.ctx, ast.Store) and id(each) not in grown:
            yield each.attr


def members_bound(body: list[ast.stmt]) -> Iterator[str]:
    """Yield what the body of a class binds, also in branches."""
    for node in below_statements(body):
        match node:
            case ast.FunctionDef(name=name) | ast.AsyncFunctionDef(name=name) | ast.ClassDef(name=name):
                yield name
            case ast.Name(id=name, ctx=ast.Store()):
                yield name
            case ast.alias():
                yield (node.asname or node.name).partition(".")[0]


def below_statements(body: list[ast.stmt]) -> Iterator[ast.AST]:
    waiting: list[ast.AST] = [*body]
    while waiting:
        node = waiting.pop()
        yield node
        waiting += [] if isinstance(node, FunctionNode | ast.ClassDef | ast.Lambda) else children_of(node)

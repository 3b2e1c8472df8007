"""Code that goes on where an exception is raised in it."""

from __future__ import annotations

import ast
from collections.abc import Collection, Iterable, Iterator

from ...source import Span
from .file import PythonFile
from .nodes import nodes_of, nodes_of_kind

BLOCKS = (ast.Try, ast.With)
SUPPRESS = "suppress"


def guarded_nodes(body: Iterable[ast.AST], errors: Collection[str]) -> Iterator[int]:
    """Yield the identity of each node in a `try` whose handlers catch one of some exceptions, or all.

    A `with suppress(…)` of contextlib is such a block as well.
    """
    for statement in body:
        for node in nodes_of(statement):
            if isinstance(node, BLOCKS) and catches(node, errors):
                yield from (id(inner) for each in node.body for inner in nodes_of(each))


def catches(block: ast.Try | ast.With, errors: Collection[str]) -> bool:
    if isinstance(block, ast.With):
        return any(suppresses(each.context_expr, errors) for each in block.items)
    types = [handler.type for handler in block.handlers]
    named = {node.id for each in types if each for node in nodes_of(each) if isinstance(node, ast.Name)}
    named |= {node.attr for each in types if each for node in nodes_of(each) if isinstance(node, ast.Attribute)}
    return None in types or not named.isdisjoint(errors)


def suppresses(manager: ast.expr, errors: Collection[str]) -> bool:
    """Return whether a context manager is `suppress(…)` or `contextlib.suppress(…)` of one of some exceptions."""
    if not isinstance(manager, ast.Call) or ast.unparse(manager.func).rpartition(".")[2] != SUPPRESS:
        return False
    return any(ast.unparse(each).rpartition(".")[2] in errors for each in manager.args)


def is_guarded(file: PythonFile, span: Span, errors: Collection[str]) -> bool:
    """Return whether a place is in a `try` whose handlers catch one of some exceptions, or all."""
    every: list[ast.Try | ast.With] = [*nodes_of_kind(file.tree, ast.Try), *nodes_of_kind(file.tree, ast.With)]
    return any(file.span(part).holds(span) for each in every if catches(each, errors) for part in each.body)

"""Code that goes on where an exception is raised in it."""

from __future__ import annotations

import ast
from collections.abc import Collection, Iterable, Iterator

from ...source import Span
from .file import PythonFile
from .nodes import nodes_of, nodes_of_kind


def guarded_nodes(body: Iterable[ast.AST], errors: Collection[str]) -> Iterator[int]:
    """Yield the identity of each node in a `try` whose handlers catch one of some exceptions, or all."""
    for statement in body:
        for node in nodes_of(statement):
            if isinstance(node, ast.Try) and catches(node, errors):
                yield from (id(inner) for each in node.body for inner in nodes_of(each))


def catches(block: ast.Try, errors: Collection[str]) -> bool:
    types = [handler.type for handler in block.handlers]
    named = {node.id for each in types if each for node in nodes_of(each) if isinstance(node, ast.Name)}
    named |= {node.attr for each in types if each for node in nodes_of(each) if isinstance(node, ast.Attribute)}
    return None in types or not named.isdisjoint(errors)


def is_guarded(file: PythonFile, span: Span, errors: Collection[str]) -> bool:
    """Return whether a place is in a `try` whose handlers catch one of some exceptions, or all."""
    tries = (each for each in nodes_of_kind(file.tree, ast.Try) if catches(each, errors))
    return any(file.span(part).holds(span) for each in tries for part in each.body)

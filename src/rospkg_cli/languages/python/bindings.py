"""The names that statements of Python bind in their scope."""

from __future__ import annotations

import ast
from collections.abc import Iterable, Iterator

from .nodes import children_of, nodes_of

NEW_SCOPES = frozenset({ast.Lambda, ast.ListComp, ast.SetComp, ast.DictComp, ast.GeneratorExp})
BINDERS = NEW_SCOPES | {
    ast.Name, ast.FunctionDef, ast.AsyncFunctionDef, ast.ClassDef, ast.Import, ast.ImportFrom,
    ast.MatchAs, ast.MatchStar, ast.MatchMapping,
}  # fmt: skip
"""What binds a name in its scope, or none of it."""


def bindings(
    body: Iterable[ast.AST], *, has_globals: bool = True
) -> Iterator[tuple[str, ast.stmt | ast.expr | ast.alias | ast.pattern]]:
    """Yield the names that statements bind in their scope, with the binding node.

    Without `has_globals` no function says `global`: then functions are not looked into.
    """
    waiting = [*body][::-1]
    while waiting:  # without recursion, as every expression is looked through
        node = waiting.pop()
        if node.__class__ not in BINDERS:
            waiting += children_of(node)[::-1]
            continue
        match node:
            case ast.Name():
                if isinstance(node.ctx, ast.Store):
                    yield node.id, node
            case ast.FunctionDef() | ast.AsyncFunctionDef() | ast.ClassDef():
                yield node.name, node
                yield from ((name, node) for name in (global_names(node) if has_globals else ()))
            case ast.Import():
                yield from ((alias.asname or alias.name.partition(".")[0], alias) for alias in node.names)
            case ast.ImportFrom():
                yield from ((alias.asname or alias.name, alias) for alias in node.names if alias.name != "*")
            case ast.MatchAs(name=name) | ast.MatchStar(name=name) | ast.MatchMapping(rest=name):
                waiting += children_of(node)[::-1]
                yield from [(name, node)] if name else []


def global_names(function: ast.AST) -> set[str]:
    return {name for node in nodes_of(function) if isinstance(node, ast.Global) for name in node.names}

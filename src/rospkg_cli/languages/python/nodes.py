"""The nodes of a syntax tree, found once however many ask.

What a tree repeats at every name (`ast.Load` and the like) is left out: it says nothing that its node doesn't.
"""

from __future__ import annotations

import ast
import operator
from collections.abc import Callable, Mapping
from typing import Any, TypeVar, cast

NodeT = TypeVar("NodeT", bound=ast.AST)
FunctionNode = ast.FunctionDef | ast.AsyncFunctionDef

NO_NODES = frozenset({int, str, float, bool, bytes, complex, type(None), *ast.expr_context.__subclasses__()})
"""The classes of values that are no node."""

CHILDLESS = frozenset({ast.Name, ast.Constant, ast.alias, ast.Global, ast.Nonlocal, ast.Pass, ast.Break, ast.Continue})

COMPARISONS: Mapping[type[ast.cmpop], Callable[[Any, Any], bool]] = {
    ast.Eq: operator.eq, ast.NotEq: operator.ne,
    ast.Lt: operator.lt, ast.LtE: operator.le, ast.Gt: operator.gt, ast.GtE: operator.ge,
}  # fmt: skip
"""What the signs mean that compare by value."""


class NodeList(list[ast.AST]):
    """The nodes below one, kept with it; no plain list, so that it is not taken for a field of the node."""

    levels = 0
    """How many nodes stand inside each other at most."""


def last_name(node: ast.AST) -> str:
    """Return the name of a node, or of its attribute: `c` of `a.b.c`; "" for any other expression."""
    match node:
        case ast.Name(id=name) | ast.Attribute(attr=name):
            return name
    return ""


def children_of(node: ast.AST) -> list[ast.AST]:
    """Return what `ast.iter_child_nodes` yields, without contexts."""
    found: list[ast.AST] = []
    if node.__class__ not in CHILDLESS:
        for value in node.__dict__.values():  # in the order of its fields
            if value.__class__ is list:
                found += [each for each in value if isinstance(each, ast.AST)]
            elif value.__class__ not in NO_NODES and isinstance(value, ast.AST):
                found.append(value)
    return found


def nodes_below(root: ast.AST) -> NodeList:
    """Return what `ast.walk` yields behind its root, in its order, without contexts."""
    known = root.__dict__
    below: NodeList | None = known.get("nodes_below")
    if below is None:
        below, level, has_node = NodeList(), children_of(root), ast.AST
        while level:
            below += level
            below.levels += 1
            following: list[ast.AST] = []
            for node in level:
                if node.__class__ not in CHILDLESS:
                    for value in node.__dict__.values():
                        kind = value.__class__
                        if kind is list:
                            following += [each for each in value if isinstance(each, has_node)]
                        elif kind not in NO_NODES and isinstance(value, has_node):
                            following.append(value)
            level = following
        known["nodes_below"] = below  # without the root, or it could not be freed without the collector
    return below


def nodes_of(root: ast.AST) -> list[ast.AST]:
    """Return what `ast.walk` yields, in its order, without contexts; kept with the root, as no tree is changed here."""
    return [root, *nodes_below(root)]


def nodes_of_kind(root: ast.AST, kind: type[NodeT]) -> list[NodeT]:
    """Return the nodes below one that are of a class, in the order of `nodes_of`."""
    by_kind: dict[type, list[ast.AST]] | None = root.__dict__.get("nodes_by_kind")
    if by_kind is None:
        by_kind = root.__dict__["nodes_by_kind"] = {}
        for node in nodes_below(root):
            by_kind.setdefault(node.__class__, []).append(node)
    return cast("list[NodeT]", by_kind.get(kind, []))


def functions_of(root: ast.AST) -> list[FunctionNode]:
    return [*nodes_of_kind(root, ast.FunctionDef), *nodes_of_kind(root, ast.AsyncFunctionDef)]


def defaults_of(arguments: ast.arguments) -> list[tuple[ast.arg, ast.expr]]:
    """Return the parameters with a default, each with it."""
    last = [*arguments.posonlyargs, *arguments.args][-len(arguments.defaults) :] if arguments.defaults else []
    named = zip(arguments.kwonlyargs, arguments.kw_defaults, strict=True)
    return [*zip(last, arguments.defaults, strict=True), *((each, value) for each, value in named if value is not None)]

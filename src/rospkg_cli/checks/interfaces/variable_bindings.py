"""Names that the body of a function or a module binds, each with its value and its annotation."""

from __future__ import annotations

import ast
from collections.abc import Iterator

from ...languages.python.attributes import is_of_self
from ...languages.python.nodes import CHILDLESS, children_of

ENDS = CHILDLESS | {ast.FunctionDef, ast.AsyncFunctionDef, ast.ClassDef, ast.Lambda}
"""Nodes whose children belong to another scope, or that have none."""
BINDERS = frozenset({
    ast.Assign, ast.AnnAssign, ast.Name, ast.Attribute, ast.ExceptHandler, ast.MatchAs, ast.MatchStar, ast.Global,
    ast.Nonlocal, ast.FunctionDef, ast.AsyncFunctionDef, ast.ClassDef,
})  # fmt: skip
"""Nodes that may bind a variable."""
NAMES = (ast.Name, ast.Attribute)
PATTERNS = (ast.ExceptHandler, ast.MatchAs, ast.MatchStar)
SHARED = (ast.Global, ast.Nonlocal)
DEFINITIONS = (ast.FunctionDef, ast.AsyncFunctionDef, ast.ClassDef)


def own_nodes(body: list[ast.stmt]) -> list[ast.AST]:
    """Return the nodes of statements, without those in functions, classes and lambdas in them, level by level."""
    found: list[ast.AST] = []
    level: list[ast.AST] = [*body]
    while level:
        found += level
        level = [inner for node in level if node.__class__ not in ENDS for inner in children_of(node)]
    return found


class Bindings:
    """The variables that a body binds, each with the expressions of its value and annotation, None where unknown.

    `x = None` is left out: any use of such a value fails anyway. Several checks share one object for each body.
    """

    def __init__(self, body: list[ast.stmt]) -> None:
        self.body = body
        self.nodes = own_nodes(body)
        self.values = tuple(bound_values([node for node in self.nodes if node.__class__ in BINDERS]))


def name_of(node: ast.AST) -> str:
    """Return `x` or `self.x`; "" for other expressions."""
    if isinstance(node, ast.Name):
        return node.id
    if is_of_self(node):
        return f"self.{node.attr}"
    return ""


def bound_values(nodes: list[ast.AST]) -> Iterator[tuple[str, ast.expr | None, ast.expr | None]]:
    """Yield the name, value and annotation of each variable that some nodes bind; None for what is not known."""
    plain: set[int] = set()
    for node in nodes:
        if isinstance(node, ast.Assign) and len(node.targets) == 1 and (name := name_of(node.targets[0])):
            plain.add(id(node.targets[0]))
            if not (isinstance(node.value, ast.Constant) and node.value.value is None):
                yield name, node.value, None
        elif isinstance(node, ast.AnnAssign) and (name := name_of(node.target)):
            plain.add(id(node.target))
            yield name, node.value, node.annotation
    for node in nodes:
        if isinstance(node, NAMES):
            if not isinstance(node.ctx, ast.Load) and id(node) not in plain:
                yield name_of(node), None, None
        elif isinstance(node, PATTERNS):
            if node.name:
                yield node.name, None, None
        elif isinstance(node, SHARED):
            yield from ((name, None, None) for name in node.names)
        elif isinstance(node, DEFINITIONS):
            yield node.name, None, None

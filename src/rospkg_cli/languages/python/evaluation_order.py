"""The order in which Python evaluates the parts of a statement or an expression."""

from __future__ import annotations

import ast
from collections.abc import Sequence

from .nodes import children_of

PLAIN = (
    ast.Expr, ast.Return, ast.Call, ast.keyword, ast.Starred, ast.Attribute, ast.Subscript, ast.BinOp, ast.UnaryOp,
    ast.Compare, ast.List, ast.Tuple, ast.Set, ast.JoinedStr, ast.FormattedValue,
)  # fmt: skip
"""What evaluates all of its parts, as they stand in the text: a receiver and the arguments before the call."""


def in_order(node: ast.AST) -> Sequence[ast.AST]:
    """Return the parts of a node in the order in which they are evaluated; none where some may not be at all."""
    match node:
        case ast.Assign(targets=targets, value=value):
            return [value, *targets]
        case ast.AnnAssign(target=target, value=ast.expr() as value) | ast.NamedExpr(target=target, value=value):
            return [value, target]
        case ast.AugAssign(target=target, value=value):
            return [target, value]
    return children_of(node) if isinstance(node, PLAIN) else []

"""Calls of Python that run when a module is imported."""

from __future__ import annotations

import ast
from collections.abc import Iterable, Iterator

from .nodes import nodes_of

STARTERS = frozenset({"spin", "run", "exec", "exec_", "mainloop", "main"})
"""Methods that do not return before the program ends: `rclpy.spin(node)`, `app.exec()`."""


def statement_calls(body: Iterable[ast.stmt]) -> Iterator[ast.Call]:
    """Yield the calls that are statements of their own where a module is imported."""
    for node in body:
        match node:
            case ast.Expr(value=ast.Call() as call):
                yield call
            case ast.If() if any(isinstance(each, ast.Name) and each.id == "__name__" for each in nodes_of(node.test)):
                continue
            case ast.If() | ast.While() | ast.For():
                yield from statement_calls([*node.body, *node.orelse])
            case ast.Try():
                yield from statement_calls([*node.body, *node.orelse, *node.finalbody])
            case ast.With():
                yield from statement_calls(node.body)

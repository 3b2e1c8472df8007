"""Whether a place in a function runs only under a condition."""

from __future__ import annotations

import ast
from collections.abc import Sequence

from ...source import Span
from .file import PythonFile
from .nodes import FunctionNode, nodes_below, nodes_of
from .syntax import PositionedNode


def is_under_condition(file: PythonFile, span: Span) -> bool:
    """Return whether a place is in a branch, a handler or a guarded loop of the function around it."""
    around = [each for each in nodes_of(file.tree) if isinstance(each, FunctionNode) and file.span(each).holds(span)]
    inner = max(around, key=lambda each: file.span(each).start, default=None)
    nodes = nodes_below(inner) if inner is not None else ()
    return any(file.span(part).holds(span) for node in nodes for part in guarded(node))


def guarded(node: ast.AST) -> Sequence[PositionedNode]:
    """Return what runs only under a condition; a loop for as long as ROS runs has none."""
    match node:
        case ast.If() | ast.IfExp():
            parts = node.body, node.orelse
            return [each for part in parts for each in (part if isinstance(part, list) else [part])]
        case ast.BoolOp():
            return node.values[1:]
        case ast.While(test=ast.UnaryOp() | ast.Compare()) | ast.ExceptHandler() | ast.match_case():
            return node.body
    return ()

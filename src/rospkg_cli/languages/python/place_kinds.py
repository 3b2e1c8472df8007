"""Whether a place of a Python file certainly, perhaps or never runs, by the statements around it."""

from __future__ import annotations

import ast

from ...source import Span
from .constant_truth import unreached_statements
from .file import PythonFile
from .nodes import nodes_of

FunctionNode = ast.FunctionDef | ast.AsyncFunctionDef | ast.Lambda


def is_in_branch(file: PythonFile, span: Span) -> bool:
    """Return whether a place is in a branch of an `if`, which may not run."""
    for node in ast.walk(file.tree):
        bodies: list[ast.stmt] | list[ast.expr] = []
        if isinstance(node, ast.If):
            bodies = [*node.body, *node.orelse]
        elif isinstance(node, ast.IfExp):
            bodies = [node.body, node.orelse]
        if any(file.span(each).start <= span.start and span.end <= file.span(each).end for each in bodies):
            return True
    return False


def is_passed_over(file: PythonFile, span: Span) -> bool:
    """Return whether a place is in a branch of a condition on a constant, or behind what leaves its block."""
    statements = unreached_statements(nodes_of(file.tree), file.constants)
    return any(file.span(each).contains(span) for each in statements)


def is_run(file: PythonFile, span: Span) -> bool:
    """Return whether a place certainly runs: it is in a plain statement of the top level."""
    plain = (file.span(node) for node in file.tree.body if isinstance(node, ast.Expr | ast.Assign))
    return any(each.contains(span) for each in plain)


def is_in_function(file: PythonFile, span: Span) -> bool:
    """Return whether a place is in a function, which may not be called."""
    spans = (file.span(node) for node in nodes_of(file.tree) if isinstance(node, FunctionNode))
    return any(each.holds(span) for each in spans)

"""Imports that may fail, as a handler has something else in their place."""

from __future__ import annotations

import ast
from collections.abc import Iterator

from ...languages.python.file import PythonFile
from ...languages.python.import_conditions import handles_import_error
from ...languages.python.imports import Import

ENDS = frozenset({"exit", "_exit", "quit", "abort"})
LEAVES = (ast.Raise, ast.Import, ast.ImportFrom)
"""What a handler does that needs the module all the same, or another one that may not be there either."""


def is_replaced(file: PythonFile, imported: Import) -> bool:
    """Return whether an import is tried, and where it fails its names get other values: `except ImportError: A = 1`."""
    for tried in tries_around(file, imported):
        caught = [each for each in tried.handlers if handles_import_error(each)]
        inner = [node for each in caught for node in ast.walk(each)]
        is_bound = any(isinstance(node, (ast.Assign, ast.AnnAssign, ast.FunctionDef, ast.ClassDef)) for node in inner)
        if is_bound and not any(isinstance(node, LEAVES) or ends(node) for node in inner):
            return True
    return False


def tries_around(file: PythonFile, imported: Import) -> Iterator[ast.Try]:
    for node in ast.walk(file.tree):
        if isinstance(node, ast.Try) and any(file.span(each).contains(imported.span) for each in node.body):
            yield node


def ends(node: ast.AST) -> bool:
    """Return whether a call ends the program."""
    if not isinstance(node, ast.Call):
        return False
    name = node.func.attr if isinstance(node.func, ast.Attribute) else getattr(node.func, "id", "")
    return name in ENDS

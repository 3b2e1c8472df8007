"""Where a Python launch file catches the exception for a missing package or file."""

from __future__ import annotations

import ast
from collections.abc import Iterator

from ...languages.python.file import PythonFile
from ...source import Span

MISSING = frozenset({"PackageNotFoundError", "LookupError", "KeyError", "Exception", "BaseException"})
"""What ament_index raises where a package is not there, and what takes it."""

ABSENT = frozenset({"FileNotFoundError", "OSError", "IOError", "EnvironmentError", "Exception", "BaseException"})
"""What Python raises where a file is not there, and what takes it."""


def guarded_in(file: PythonFile, errors: frozenset[str] = MISSING) -> Iterator[Span]:
    """Yield the bodies of `try` whose handlers take one of some errors."""
    for node in ast.walk(file.tree):
        if isinstance(node, ast.Try) and any(catches(handler, errors) for handler in node.handlers):
            yield Span(file.span(node.body[0]).start, file.span(node.body[-1]).end)


def catches(handler: ast.ExceptHandler, errors: frozenset[str]) -> bool:
    return handler.type is None or any(
        (isinstance(each, ast.Name) and each.id in errors) or (isinstance(each, ast.Attribute) and each.attr in errors)
        for each in ast.walk(handler.type)
    )

"""Where a Python launch file reckons with a missing package."""

from __future__ import annotations

import ast
from collections.abc import Iterator

from ...source import Span
from ..python import PythonFile

MISSING = frozenset({"PackageNotFoundError", "LookupError", "KeyError", "Exception", "BaseException"})
"""What ament_index raises where a package is not there, and what takes it."""


def guarded_in(file: PythonFile) -> Iterator[Span]:
    """Yield the bodies of `try` whose handlers take what a missing package raises."""
    for node in ast.walk(file.tree):
        if isinstance(node, ast.Try) and any(catches_missing(handler) for handler in node.handlers):
            yield Span(file.span(node.body[0]).start, file.span(node.body[-1]).end)


def catches_missing(handler: ast.ExceptHandler) -> bool:
    return handler.type is None or any(
        (isinstance(each, ast.Name) and each.id in MISSING)
        or (isinstance(each, ast.Attribute) and each.attr in MISSING)
        for each in ast.walk(handler.type)
    )

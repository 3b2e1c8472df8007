"""Where an import names what it takes out of a module."""

from __future__ import annotations

import ast

from ...source import Span
from .file import PythonFile
from .imports import Import, module_span
from .nodes import nodes_of


def alias_span(file: PythonFile, each: Import, name: str) -> Span:
    """Return the span of one of the names of a `from` import."""
    for node in nodes_of(file.tree):
        if isinstance(node, ast.ImportFrom) and module_span(file, node) == each.span:
            for alias in node.names:
                if alias.name == name:
                    start = file.span(alias).start
                    return Span(start, start + len(name))
    return each.span

"""Edits of Python launch files."""

from __future__ import annotations

import ast

from ..finding import Edit
from ..languages.python.file import PythonFile
from ..source import Span


def import_name(file: PythonFile, module: str, name: str) -> tuple[Edit, ...]:
    """Import a name, sorted by module among the imports; nothing where the file has the name."""
    if name in file.definitions:
        return ()
    every = [node for node in file.tree.body if isinstance(node, ast.Import | ast.ImportFrom)]
    before = [node for node in every if module_of(node) < module or module_of(node) == "__future__"]
    text, line = file.source.text, f"from {module} import {name}"
    newline = "\r\n" if "\r\n" in text else "\n"
    if not before:
        start = file.span(every[0]).start if every else 0
        return (Edit(file.path, Span(start, start), line + newline),)
    end = text.find("\n", file.span(before[-1]).end)
    at = len(text) if end < 0 else end + 1
    return (Edit(file.path, Span(at, at), newline + line if end < 0 else line + newline),)


def module_of(node: ast.Import | ast.ImportFrom) -> str:
    return node.module or "" if isinstance(node, ast.ImportFrom) else node.names[0].name


def wrap(path: str, span: Span, before: str, after: str) -> tuple[Edit, ...]:
    """Write something around an expression."""
    start, end = Span(span.start, span.start), Span(span.end, span.end)
    return (Edit(path, start, before), Edit(path, end, after))

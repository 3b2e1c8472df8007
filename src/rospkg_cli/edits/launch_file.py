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
    at = len(text) if end == -1 else end + 1
    return (Edit(file.path, Span(at, at), newline + line if end == -1 else line + newline),)


def module_of(node: ast.Import | ast.ImportFrom) -> str:
    return node.module or "" if isinstance(node, ast.ImportFrom) else node.names[0].name


def pass_through(file: PythonFile, span: Span, call: str, last: str, width: int) -> tuple[Edit, ...]:
    """Write a call with one more argument around an expression, over several lines where one would be too long.

    Nothing where a line would be too long in either way.
    """
    text = file.source.text
    line = text.rfind("\n", 0, span.start) + 1
    end = text.find("\n", span.end)
    indent = text[line : len(text) - len(text[line:].lstrip(" \t"))]
    around = text[line : span.start], text[span.start : span.end], text[span.end : end if end != -1 else len(text)]
    newline = "\r\n" if "\r\n" in text else "\n"
    inner = f"{newline}{indent}    "
    for before, after in ((f"{call}(", f", {last})"), (f"{call}({inner}", f",{inner}{last})")):
        lines = (around[0] + before + around[1] + after + around[2]).split("\n")
        if all(len(each.rstrip()) <= width for each in lines):
            start, stop = Span(span.start, span.start), Span(span.end, span.end)
            return (Edit(file.path, start, before), Edit(file.path, stop, after))
    return ()

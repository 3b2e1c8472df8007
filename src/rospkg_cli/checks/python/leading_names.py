"""The functions and classes of a module that lead to a place in it."""

from __future__ import annotations

import ast

from ...languages.python.file import PythonFile
from ...languages.python.nodes import FunctionNode, nodes_of
from ...source import Span

Definition = FunctionNode | ast.ClassDef


def definitions(file: PythonFile) -> list[Definition]:
    return [each for each in file.tree.body if isinstance(each, Definition)]


def leading_names(file: PythonFile, span: Span) -> frozenset[str]:
    """Return the names at the top level of a module that lead to a place in a function of it."""
    around = {each.name for each in definitions(file) if file.span(each).holds(span)}
    if not around:
        return frozenset(each.name for each in definitions(file))
    while more := {each.name for each in definitions(file) if mentions(each, around)} - around:
        around |= more
    return frozenset(around)


def mentions(node: Definition, names: set[str]) -> bool:
    return any(isinstance(each, ast.Name) and each.id in names for each in nodes_of(node))

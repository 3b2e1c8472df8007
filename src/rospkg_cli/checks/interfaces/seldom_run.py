"""Places in Python code that run after another failure alone, or in a class that a later one replaces."""

from __future__ import annotations

import ast

from ...languages.python.file import PythonFile
from ...languages.python.nodes import nodes_of_kind
from ...source import Span


def is_in_handler(file: PythonFile, span: Span) -> bool:
    """Return whether a place is in an `except` branch."""
    return any(file.span(each).holds(span) for each in nodes_of_kind(file.tree, ast.ExceptHandler))


def is_replaced(file: PythonFile, span: Span) -> bool:
    """Return whether a place is in a class of a module that the module defines again further down.

    Who imports the module gets the last one; who runs it may start the first under a `__main__` before that.
    """
    classes = [each for each in file.tree.body if isinstance(each, ast.ClassDef)]
    last = {each.name: each for each in classes}
    return any(
        last[each.name] is not each and not each.decorator_list and file.span(each).holds(span) for each in classes
    )

"""Places in Python code that run after another failure alone, that whoever calls them guards, or that are replaced."""

from __future__ import annotations

import ast
from collections.abc import Collection

from ...languages.python.file import PythonFile
from ...languages.python.guarded_nodes import guarded_nodes
from ...languages.python.nodes import FunctionNode, nodes_of, nodes_of_kind
from ...source import Span


def is_in_handler(file: PythonFile, span: Span) -> bool:
    """Return whether a place is in an `except` branch, or in the exception or message of a `raise` or an assertion."""
    raised = [each.exc for each in nodes_of_kind(file.tree, ast.Raise)]
    raised += [each.msg for each in nodes_of_kind(file.tree, ast.Assert)]
    handlers = map(file.span, nodes_of_kind(file.tree, ast.ExceptHandler))
    return any(each.holds(span) for each in (*handlers, *(file.span(each) for each in raised if each is not None)))


def is_called_with_care(file: PythonFile, span: Span, errors: Collection[str]) -> bool:
    """Return whether a place is in a function whose every use is in a `try` that catches one of some exceptions."""
    around = [each for each in nodes_of(file.tree) if isinstance(each, FunctionNode) and file.span(each).holds(span)]
    names = {each.name for each in around}
    uses = [each for each in nodes_of_kind(file.tree, ast.Attribute) if each.attr in names]
    uses_by_name = [each for each in nodes_of_kind(file.tree, ast.Name) if each.id in names]
    guarded = set(guarded_nodes([file.tree], errors)) if uses or uses_by_name else set()
    return bool(guarded) and all(id(each) in guarded for each in (*uses, *uses_by_name))


def is_replaced(file: PythonFile, span: Span) -> bool:
    """Return whether a place is in a class of a module that the module defines again further down.

    Who imports the module gets the last one; who runs it may start the first under a `__main__` before that.
    """
    classes = [each for each in file.tree.body if isinstance(each, ast.ClassDef)]
    last = {each.name: each for each in classes}
    return any(
        last[each.name] is not each and not each.decorator_list and file.span(each).holds(span) for each in classes
    )

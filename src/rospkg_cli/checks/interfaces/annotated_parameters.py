"""Values that only an annotation says to be a message, in functions that other code may call with anything."""

from __future__ import annotations

import ast
import posixpath
from collections.abc import Iterable, Iterator

from ...languages.python.file import PythonFile
from ...languages.python.nodes import FunctionNode, functions_of, last_name, nodes_of_kind
from ...source import Span
from .callback_types import callback_types
from .message_classes import MessageClasses

STARTERS = frozenset({"Thread", "Timer", "Process", "partial", "partialmethod", "submit", "run_in_executor", "apply"})
"""Functions and classes that call the function they are given, with arguments that follow it."""


def is_by_annotation_alone(file: PythonFile, span: Span, message: str, files: Iterable[PythonFile]) -> bool:
    """Return whether a place is in a function with a parameter annotated as a message, whose callers are not known.

    Where the function is registered as a callback, its registration says what it is called with. Where it is passed to
    a thread or a partial, or called from another file, nothing does.
    """
    around = [each for each in functions_of(file.tree) if file.span(each).holds(span)]
    if not around:
        return False
    inner, classes = max(around, key=lambda each: file.span(each).start), MessageClasses(file)
    taken = [*inner.args.posonlyargs, *inner.args.args, *inner.args.kwonlyargs]
    if not any(each.annotation is not None and classes.message(each.annotation) == message for each in taken):
        return False
    if inner.name in {name for _, name in callback_types(file, classes)}:
        return False
    return inner.name in {*handed(file)} or any(is_called_in(each, inner, file) for each in files if each is not file)


def handed(file: PythonFile) -> Iterator[str]:
    """Yield the names of functions that a file passes to a thread, a timer, a partial or the like."""
    for call in nodes_of_kind(file.tree, ast.Call):
        if last_name(call.func) in STARTERS:
            for each in (*call.args, *(keyword.value for keyword in call.keywords)):
                if isinstance(each, ast.Name | ast.Attribute):
                    yield each.attr if isinstance(each, ast.Attribute) else each.id


def is_called_in(other: PythonFile, function: FunctionNode, file: PythonFile) -> bool:
    """Return whether another file names the module of a function and calls a function of this name."""
    stem = posixpath.basename(file.path).removesuffix(".py")
    calls = nodes_of_kind(other.tree, ast.Call) if stem in other.source.text else []
    return any(last_name(each.func) == function.name for each in calls)

"""Fields of what an annotation alone calls a message, in functions that other code hands something."""

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
"""What calls a function with arguments that stand beside it."""


def is_told_by_word(file: PythonFile, span: Span, message: str, files: Iterable[PythonFile]) -> bool:
    """Return whether a place is in a function whose annotation names a message, and that code calls unseen.

    What a function is registered for shows what it is called with; a call in another file does not.
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
    """Yield the functions that a file has something call with arguments of its own."""
    for call in nodes_of_kind(file.tree, ast.Call):
        if last_name(call.func) in STARTERS:
            for each in (*call.args, *(keyword.value for keyword in call.keywords)):
                if isinstance(each, ast.Name | ast.Attribute):
                    yield each.attr if isinstance(each, ast.Attribute) else each.id


def is_called_in(other: PythonFile, function: FunctionNode, file: PythonFile) -> bool:
    """Return whether a file that names the module of a function calls one of its name."""
    stem = posixpath.basename(file.path).removesuffix(".py")
    calls = nodes_of_kind(other.tree, ast.Call) if stem in other.source.text else []
    return any(last_name(each.func) == function.name for each in calls)

"""The annotations of Python code that no run evaluates, and what stands under `if TYPE_CHECKING`."""

from __future__ import annotations

import ast
from collections.abc import Iterator

from .file import PythonFile
from .import_conditions import is_type_checking
from .nodes import children_of, functions_of, nodes_of_kind


def unread_types(file: PythonFile) -> Iterator[ast.expr]:
    """Yield the annotations that stay unread: those of variables in functions, with the `__future__` import all."""
    if any(each.module == "__future__" and "annotations" in each.names for each in file.imports):
        yield from all_annotations(file)
        return
    for function in functions_of(file.tree):
        for node in own_nodes(function):
            if isinstance(node, ast.AnnAssign):
                yield node.annotation


def all_annotations(file: PythonFile) -> Iterator[ast.expr]:
    """Yield every annotation: of parameters, variables and what functions return."""
    yield from (each.annotation for each in nodes_of_kind(file.tree, ast.arg) if each.annotation is not None)
    yield from (each.annotation for each in nodes_of_kind(file.tree, ast.AnnAssign))
    yield from (each.returns for each in functions_of(file.tree) if each.returns is not None)


def own_nodes(function: ast.AST) -> Iterator[ast.AST]:
    """Yield the nodes of a function without those of classes in it, which evaluate the annotations of their bodies."""
    waiting = children_of(function)
    while waiting:
        node = waiting.pop()
        yield node
        waiting += [] if isinstance(node, ast.ClassDef) else children_of(node)


def for_type_checkers(file: PythonFile) -> Iterator[ast.stmt]:
    for each in nodes_of_kind(file.tree, ast.If):
        yield from each.body if is_type_checking(each.test) else ()

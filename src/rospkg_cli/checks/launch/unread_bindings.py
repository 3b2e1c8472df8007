"""Names that a Python launch file binds and nothing reads, and expressions that it binds to none (LCH018)."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator

from ...languages.python.bound_again import bound_again
from ...languages.python.file import PythonFile
from ...languages.python.nodes import nodes_of
from ...languages.python.unread_values import is_stored
from ...package.launch.never_launched import of_module


def overwritten(file: PythonFile) -> Iterator[tuple[str, ast.expr, ast.expr, int]]:
    """Yield what is bound to a name that holds something else where it is read, with the line that binds this."""
    names = {node.id for node in nodes_of(file.tree) if isinstance(node, ast.Name) and not is_stored(node)}
    for each in bound_again(file) if names.isdisjoint(("locals", "vars", "eval", "exec")) else ():
        if each.target.id in names:
            yield each.target.id, each.target, each.value, each.again.lineno


def unread(file: PythonFile) -> Iterator[tuple[str, ast.expr, ast.expr]]:
    """Yield what functions bind to a name that nothing reads, with the name's node; statements that bind nothing."""
    nodes = list(nodes_of(file.tree))
    read = {node.id for node in nodes if isinstance(node, ast.Name) and not is_stored(node)}
    if read & {"locals", "vars", "eval", "exec"}:
        return
    for function in nodes:
        for node in nodes_of(function) if isinstance(function, ast.FunctionDef) else ():
            match node:
                case ast.Assign(targets=[ast.Name(id=name) as target], value=value) if name not in read:
                    yield name, target, value
                case ast.Expr(value=ast.Call(func=function_name) as value):
                    yield "", function_name, value
                case ast.Expr(value=ast.Tuple(elts=items) | ast.List(elts=items)):  # a comma behind the action
                    yield from (("", each.func, each) for each in items if isinstance(each, ast.Call))
    for node in file.tree.body:
        match node:
            case ast.Assign(targets=[ast.Name(id=name) as target], value=value) if name in unread_names(file) - read:
                yield name, target, value


def unread_names(file: PythonFile) -> frozenset[str]:
    return frozenset(name for names, _ in of_module(file) for name in names)


def is_mentioned(name: str, file: PythonFile) -> bool:
    """Return whether a name is taken out on purpose: by a comment, a text that is no value, or a leading `_`."""
    word = re.compile(rf"\b{re.escape(name)}\b")
    comments = re.findall(r"#.*", file.source.text)
    texts = [
        node.value.value
        for node in nodes_of(file.tree)
        if isinstance(node, ast.Expr) and isinstance(node.value, ast.Constant) and isinstance(node.value.value, str)
    ]
    return name.startswith("_") or (bool(name) and any(word.search(each) for each in (*comments, *texts)))

"""Names whose text is printed as it is: nothing is opened, called or started by it."""

from __future__ import annotations

import ast
from collections.abc import Iterator

from .file import PythonFile
from .nodes import nodes_of_kind

AS_TEXT = frozenset({"str", "repr"})


def printed_names(file: PythonFile) -> Iterator[ast.Name]:
    """Yield the names that stand in `print(…)`, alone or within a text: `print(f"{path}")`, `print('at ' + path)`."""
    for statement in nodes_of_kind(file.tree, ast.Expr):
        match statement.value:
            case ast.Call(func=ast.Name(id="print"), args=args):
                for each in args:
                    yield from names_in_text(each)


def names_in_text(node: ast.expr) -> Iterator[ast.Name]:
    parts: list[ast.expr] = []
    match node:
        case ast.Name():
            yield node
        case ast.JoinedStr(values=values):
            parts = values
        case ast.FormattedValue(value=value) | ast.Starred(value=value):
            parts = [value]
        case ast.BinOp(left=left, op=ast.Add() | ast.Mod(), right=right):
            parts = [left, right]
        case ast.Tuple(elts=values) | ast.List(elts=values):
            parts = values
        case ast.Call(func=ast.Name(id=name), args=args) if name in AS_TEXT:
            parts = args
        case ast.Call(func=ast.Attribute(value=ast.Constant(value=str()), attr="format"), args=args, keywords=named):
            parts = [*args, *(each.value for each in named)]
    for each in parts:
        yield from names_in_text(each)

"""Files that a launch file names only where a search for such files has found none, which it logs (LCH003)."""

from __future__ import annotations

import ast
from collections.abc import Iterator, Mapping, Sequence
from fnmatch import fnmatchcase

from ...languages.python.file import PythonFile
from ...languages.python.nodes import last_name, nodes_of, nodes_of_kind
from ...package.launch.default_expressions import bound_once
from ...source import Span
from ..paths.logged_texts import is_log
from .searched_folders import Names, parts_of, searched_in

FOUND_NONE = "but only where a search finds no such file, which the launch then prints"
COUNTS: Mapping[tuple[type[ast.cmpop], int], bool] = {
    (ast.Eq, 0): True, (ast.LtE, 0): True, (ast.Lt, 1): True,
    (ast.NotEq, 0): False, (ast.Gt, 0): False, (ast.GtE, 1): False,
}  # fmt: skip
"""Comparisons of a length, and whether they hold where there is nothing."""
Block = list[ast.stmt]


def is_found_none(file: PythonFile, span: Span) -> bool:
    """Return whether a path is used only where a search finds no such file, in a branch that logs this."""
    return any(is_lacked_at(node, span, file) for node in nodes_of(file.tree))


def is_lacked_at(node: ast.AST, span: Span, file: PythonFile) -> bool:
    """Return whether a place is in a branch of a statement that runs where a search finds nothing, and logs it."""
    for block, searched in lacking(node, file):
        around = Span(file.span(block[0]).start, file.span(block[-1]).end)
        path = named_at(block, span, file) if around.contains(span) and has_log(block) else None
        if path is not None:
            names = bound_once(file.tree)
            return any(fits(path, each, names) for each in searched)
    return False


def lacking(node: ast.AST, file: PythonFile) -> Iterator[tuple[Block, Sequence[ast.AST]]]:
    """Yield the branches that run where nothing is found, each with the expressions that search."""
    if isinstance(node, ast.Try):
        yield from ((each.body, node.body) for each in node.handlers)
    elif isinstance(node, ast.If) and (tested := emptiness(node.test)):
        name, is_empty = tested
        block = node.body if is_empty else node.orelse
        bound = [each for each in nodes_of_kind(file.tree, ast.Assign) if name in map(last_name, each.targets)]
        if block and bound:
            yield block, [each.value for each in bound]


def emptiness(test: ast.expr) -> tuple[str, bool] | None:
    """Return which name a test asks for, and whether it is true where that has nothing; None for other tests."""
    match test:
        case ast.Name(id=name):
            return name, False
        case ast.UnaryOp(op=ast.Not(), operand=ast.Name(id=name)):
            return name, True
        case ast.Compare(
            left=ast.Call(func=ast.Name(id="len"), args=[ast.Name(id=name)]),
            ops=[sign],
            comparators=[ast.Constant(value=int(least))],
        ):
            is_empty = COUNTS.get((type(sign), least))
            return (name, is_empty) if is_empty is not None else None
    return None


def has_log(block: Block) -> bool:
    return any(isinstance(node, ast.Call) and is_log(node) for each in block for node in nodes_of(each))


def named_at(block: Block, span: Span, file: PythonFile) -> ast.expr | None:
    """Return the expression of a path that stands at a place."""
    every = (node for each in block for node in nodes_of(each) if isinstance(node, ast.expr))
    return next((node for node in every if file.span(node) == span), None)


def fits(path: ast.expr, searched: ast.AST, names: Names) -> bool:
    """Return whether a search would have found a path."""
    *folder, name = parts_of(path, names)
    found = searched_in(searched, names)
    return any(around == folder and fnmatchcase(name, pattern) for around, pattern in found)

"""What of a Python file does not run any more once a place of it has raised."""

from __future__ import annotations

import ast
from collections.abc import Iterable, Iterator, Sequence

from ...lazy_regex import regex
from ...source import Span
from .file import PythonFile
from .nodes import FunctionNode, functions_of, nodes_below, nodes_of

BRANCHES = (ast.If, ast.For, ast.AsyncFor, ast.While, ast.Try, ast.ExceptHandler, ast.match_case)
APART = (ast.Lambda, ast.ListComp, ast.SetComp, ast.DictComp, ast.GeneratorExp)
SWALLOWS = regex(r"\b(?:suppress|raises)\b")
"""Context managers that exceptions do not leave."""
BLOCKS = ("body", "orelse", "finalbody")


def bodies(file: PythonFile) -> list[tuple[Span, FunctionNode]]:
    """Return the functions of a file with the spans of their bodies."""
    return [(body_of(file, each), each) for each in functions_of(file.tree)]


def unit_at(units: Iterable[tuple[Span, FunctionNode]], place: int) -> FunctionNode | None:
    """Return the innermost function whose body holds a place; None where that is the module."""
    found = (each for each in units if each[0].start <= place < each[0].end)
    return max(found, key=lambda each: each[0].start, default=(None, None))[1]


def body_of(file: PythonFile, node: FunctionNode) -> Span:
    return around(file, node.body)


def around(file: PythonFile, block: Sequence[ast.stmt]) -> Span:
    return Span(file.span(block[0]).start, file.span(block[-1]).end)


def region_behind(file: PythonFile, unit: FunctionNode | None, stop: Span) -> Span | None:
    """Return what is skipped where a place of a function raises: the rest of its branch, or else of the function.

    It is None where the place may not be come to at all: in a lambda, or in what follows `and`.
    """
    nodes = nodes_below(unit) if unit is not None else nodes_of(file.tree)
    if any(file.span(part).holds(stop) for each in nodes for part in seldom(each)):
        return None
    end = body_of(file, unit).end if unit is not None else len(file.source.text)
    for block in blocks(nodes):
        if (held := around(file, block)).holds(stop):
            end = min(end, held.end)
    return Span(stop.end, end)


def blocks(nodes: Iterable[ast.AST]) -> Iterator[Sequence[ast.stmt]]:
    for each in nodes:
        is_swallowing = isinstance(each, ast.With) and any(SWALLOWS.search(ast.unparse(one)) for one in each.items)
        if isinstance(each, BRANCHES) or is_swallowing:
            yield from (block for name in BLOCKS if (block := getattr(each, name, None)))


def seldom(node: ast.AST) -> Sequence[ast.expr]:
    """Return the parts of an expression that may not be evaluated where it is."""
    match node:
        case ast.IfExp():
            return [node.body, node.orelse]
        case ast.BoolOp():
            return node.values[1:]
    return [node] if isinstance(node, APART) else []


def raises_when_called(function: FunctionNode) -> bool:
    """Return whether a call of a function runs its body at once."""
    is_plain = isinstance(function, ast.FunctionDef) and not function.decorator_list
    return is_plain and not any(isinstance(each, ast.Yield | ast.YieldFrom) for each in nodes_below(function))

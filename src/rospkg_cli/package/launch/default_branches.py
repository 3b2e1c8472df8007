"""Branches of Python that a launch file takes only where an argument, or a variable, has another value than usual."""

from __future__ import annotations

import ast
from collections.abc import Iterator, Mapping

from ...languages.python.file import PythonFile
from ...languages.python.nodes import functions_of, nodes_below
from ...source import Span
from .asked_packages import blocks_of, leaves
from .default_expressions import Values, bound_once
from .default_helpers import helpers_in


def untaken_branches(file: PythonFile, arguments: Mapping[str, str]) -> Iterator[tuple[Span, str]]:
    """Yield the parts of functions and of the module, each with the argument that leads there: `sim:=true`."""
    outer, helpers = bound_once(file.tree), helpers_in(file)
    for part in (file.tree, *functions_of(file.tree)):
        names = {**outer, **bound_once(part)}
        for node in [part, *nodes_below(part)]:
            for block in blocks_of(node):
                yield from untaken_in(block, file, Values(names, arguments, helpers))


def untaken_in(block: list[ast.stmt], file: PythonFile, values: Values) -> Iterator[tuple[Span, str]]:
    for at, each in enumerate(block):
        if not isinstance(each, ast.If):
            continue
        truth, argument = values.truth(each.test)
        lost = each.orelse if truth else each.body
        if truth is not None and argument and lost:
            yield span_of(lost, file), argument
        if truth and argument and leaves(each.body) and block[at + 1 :]:
            yield span_of(block[at + 1 :], file), argument


def span_of(statements: list[ast.stmt], file: PythonFile) -> Span:
    return Span(file.span(statements[0]).start, file.span(statements[-1]).end)

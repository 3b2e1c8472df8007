"""Where a Python file asks whether packages are there before it uses them."""

from __future__ import annotations

import ast
from collections.abc import Iterator, Mapping

from ...languages.python.file import PythonFile
from ...languages.python.import_conditions import asked
from ...languages.python.nodes import last_name, nodes_of, nodes_of_kind
from ...source import Span
from .exception_guards import LOOKUPS, MISSING, catching

BRANCHING = frozenset({
    ast.Module, ast.FunctionDef, ast.AsyncFunctionDef, ast.ClassDef, ast.If, ast.IfExp, ast.For, ast.AsyncFor,
    ast.While, ast.With, ast.AsyncWith, ast.Try, ast.ExceptHandler, ast.match_case, getattr(ast, "TryStar", ast.Try),
})  # fmt: skip
"""The classes of nodes with conditions, or with lists of statements."""


def asked_in(file: PythonFile) -> Iterator[tuple[Span, frozenset[str]]]:
    """Yield what runs under a condition on the names of packages: `if 'pkg' in get_packages_with_prefixes():`.

    A condition may be assigned to a name first; one whose body leaves (`return`, `raise`) holds for what follows.
    """
    named = dict(named_conditions(file))
    for node in nodes_of(file.tree):
        if node.__class__ not in BRANCHING:
            continue
        if isinstance(node, ast.If | ast.IfExp) and (names := asked_by(node.test, named)):
            yield file.span(node), names
        for block in blocks_of(node):
            for each in block:
                if isinstance(each, ast.If) and leaves(each.body) and (names := asked_by(each.test, named)):
                    yield Span(file.span(each).start, file.span(block[-1]).end), names


def blocks_of(node: ast.AST) -> list[list[ast.stmt]]:
    """Return the lists of statements of a module, a function, a loop or a branch."""
    found = (getattr(node, field, None) for field in ("body", "orelse"))
    return [block for block in found if isinstance(block, list)]


def asked_by(test: ast.expr, named: Mapping[str, frozenset[str]]) -> frozenset[str]:
    """Return the strings that a condition asks for, itself or by the name of an earlier one."""
    names = (node.id for node in nodes_of(test) if isinstance(node, ast.Name))
    return asked(test).union(*(named.get(name, frozenset()) for name in names))


def named_conditions(file: PythonFile) -> Iterator[tuple[str, frozenset[str]]]:
    """Yield the names that tell whether packages are there, and which: of a comparison, or bound where a look-up is
    caught (`try: get_package_share_directory('pkg'); has_pkg = True`).
    """
    for node in nodes_of_kind(file.tree, ast.Assign):
        if isinstance(node.value, ast.Compare) and (names := asked(node.value)):
            yield from ((target.id, names) for target in node.targets if isinstance(target, ast.Name))
    for each in catching(file, MISSING):
        if names := frozenset(name for statement in each.body for name in looked_up(statement)):
            others = (statement for handler in each.handlers for statement in handler.body)
            lost = {name for statement in others for name in bound_in(statement)}
            bound = {name for statement in (*each.body, *each.orelse) for name in bound_in(statement)}
            yield from ((name, names) for name in sorted(bound & lost or bound))


def looked_up(statement: ast.stmt) -> Iterator[str]:
    """Yield the packages that a statement looks for by their names."""
    for node in nodes_of(statement):
        if isinstance(node, ast.Call) and last_name(node.func) in LOOKUPS and node.args:
            given = node.args[0]
            if isinstance(given, ast.Constant) and isinstance(given.value, str):
                yield given.value


def bound_in(statement: ast.stmt) -> Iterator[str]:
    if isinstance(statement, ast.Assign):
        yield from (target.id for target in statement.targets if isinstance(target, ast.Name))


def leaves(body: list[ast.stmt]) -> bool:
    return isinstance(body[-1], ast.Return | ast.Raise | ast.Continue)

"""Cases, halves of expressions and entries of tables that a launch file chooses only by another value than usual."""

from __future__ import annotations

import ast
from collections.abc import Iterator, Mapping

from ...languages.python.file import PythonFile
from ...languages.python.nodes import functions_of, nodes_below, nodes_of_kind
from ...source import Span
from .asked_defaults import Defaults
from .default_branches import span_of
from .default_expressions import Values, bound_once
from .default_helpers import helpers_in
from .plain_values import NotKnownError, plain_value

Choice = tuple[Span, str, bool]
"""A part, what leads there (`lidar:=velodyne`), and whether Python itself does not run it."""


def untaken_choices(file: PythonFile, arguments: Mapping[str, str]) -> Iterator[Choice]:
    """Yield the parts that are not chosen; all of a table is made by Python, and one entry is used."""
    outer, helpers = bound_once(file.tree), helpers_in(file)
    for part in (file.tree, *functions_of(file.tree)):
        values = Values({**outer, **bound_once(part)}, arguments, helpers)
        for node in nodes_below(part):
            match node:
                case ast.Match(subject=subject, cases=cases):
                    yield from lost_cases(usual(subject, values), cases, file, values)
                case ast.IfExp(test=test, body=body, orelse=other):
                    truth, argument = values.truth(test)
                    if truth is not None and argument:
                        yield file.span(other if truth else body), argument, True
                case (
                    ast.Subscript(value=ast.Name(id=name), slice=key)
                    | ast.Call(func=ast.Attribute(value=ast.Name(id=name), attr="get"), args=[key, *_])
                ):
                    yield from lost_entries(name, key, file, values)


def usual(node: ast.expr, values: Values) -> object:
    """Return what an expression is with the defaults; None where that is not known, or depends on none of them."""
    values.defaults, values.steps = Defaults(values.defaults.arguments), 0
    try:
        found = plain_value(node, values.known)
    except NotKnownError:
        return None
    return found if values.defaults.asked else None


def lost_cases(value: object, cases: list[ast.match_case], file: PythonFile, values: Values) -> Iterator[Choice]:
    """Yield the cases of constants that are not taken; nothing where a case of another kind may be taken."""
    taken = next((each for each in cases if may_take(each, value)), None)
    is_certain = taken is None or constants_of(taken) or is_rest(taken)
    for each in cases if isinstance(value, str) and is_certain else ():
        if each is not taken and (found := constants_of(each)):
            yield span_of(each.body, file), f"{next(iter(values.defaults.asked))}{found[0]}", True


def may_take(case: ast.match_case, value: object) -> bool:
    found = constants_of(case)
    return not found or value in found


def is_rest(case: ast.match_case) -> bool:
    """Return whether a case takes whatever is left: `case _:`."""
    return isinstance(case.pattern, ast.MatchAs) and case.pattern.pattern is None and case.guard is None


def constants_of(case: ast.match_case) -> list[object]:
    """Return the constants that a case is for; nothing for another kind of pattern, or one with a guard."""
    patterns = case.pattern.patterns if isinstance(case.pattern, ast.MatchOr) else [case.pattern]
    values = [each.value for each in patterns if isinstance(each, ast.MatchValue)]
    found: list[object] = [each.value for each in values if isinstance(each, ast.Constant)]
    return found if len(found) == len(patterns) and case.guard is None else []


def lost_entries(name: str, key: ast.expr, file: PythonFile, values: Values) -> Iterator[Choice]:
    """Yield the other entries of a table that is looked into once, where the key is known."""
    table = values.names.get(name)
    if not isinstance(table, ast.Dict) or sum(each.id == name for each in nodes_of_kind(file.tree, ast.Name)) != 2:
        return
    value = usual(key, values)
    for each, entry in zip(table.keys, table.values, strict=True) if isinstance(value, str) else ():
        if isinstance(each, ast.Constant) and isinstance(each.value, str) and each.value != value:
            yield file.span(entry), f"{next(iter(values.defaults.asked))}{each.value}", False

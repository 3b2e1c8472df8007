"""Where a Python file catches the exception for a missing package or file."""

from __future__ import annotations

import ast
from collections.abc import Collection, Iterator

from ...languages.python.file import PythonFile
from ...languages.python.guarded_nodes import suppresses
from ...languages.python.nodes import functions_of, last_name, nodes_of, nodes_of_kind
from ...source import Span

MISSING = frozenset({"PackageNotFoundError", "LookupError", "KeyError", "Exception", "BaseException"})
"""What ament_index raises where a package is not there, and what takes it."""

LOOKUPS = frozenset({"get_package_share_directory", "get_package_share_path", "get_package_prefix", "FindPackageShare"})


ABSENT = frozenset({"FileNotFoundError", "OSError", "IOError", "EnvironmentError", "Exception", "BaseException"})
"""What Python raises where a file is not there, and what takes it."""


def guarded_in(file: PythonFile, errors: frozenset[str] = MISSING) -> Iterator[Span]:
    """Yield the bodies of `try` whose handlers take one of some errors, and of `with suppress(…)`, and calls of
    functions that look for packages in one.
    """
    bodies = [each.body for each in catching(file, errors)]
    managed = (each for each in nodes_of_kind(file.tree, ast.With))
    bodies += [each.body for each in managed if any(suppresses(one.context_expr, errors) for one in each.items)]
    for body in bodies:
        yield Span(file.span(body[0]).start, file.span(body[-1]).end)
    yield from guarded_calls(file, bodies) if errors is MISSING else ()


def catching(file: PythonFile, errors: frozenset[str]) -> Iterator[ast.Try]:
    for each in nodes_of_kind(file.tree, ast.Try):
        if any(catches(one, errors) for one in each.handlers):
            yield each


def guarded_calls(file: PythonFile, bodies: list[list[ast.stmt]]) -> Iterator[Span]:
    """Yield the calls of the file's functions of which each lookup by a parameter is in one of some bodies."""
    inside = {id(node) for body in bodies for each in body for node in nodes_of(each)}
    names: set[str] = set()
    for function in functions_of(file.tree) if inside else ():
        given = {each.arg for each in function.args.args}
        looks = [node for node in nodes_of(function) if isinstance(node, ast.Call) and looks_by(node, given)]
        if looks and all(id(each) in inside for each in looks):
            names.add(function.name)
    for node in nodes_of_kind(file.tree, ast.Call) if names else ():
        if isinstance(node.func, ast.Name) and node.func.id in names:
            yield file.span(node)


def looks_by(call: ast.Call, names: Collection[str]) -> bool:
    """Return whether a call looks for a package that one of some names says."""
    given = call.args[0] if call.args else None
    return last_name(call.func) in LOOKUPS and isinstance(given, ast.Name) and given.id in names


def silent_in(file: PythonFile) -> Iterator[Span]:
    """Yield the bodies of `try` that go on with nothing where a file is not there: `except OSError: return None`."""
    for node in nodes_of_kind(file.tree, ast.Try):
        found = [handler for handler in node.handlers if catches(handler, ABSENT)]
        if found and all(len(each.body) == 1 and gives_nothing(each.body[0]) for each in found):
            yield Span(file.span(node.body[0]).start, file.span(node.body[-1]).end)


def gives_nothing(statement: ast.stmt) -> bool:
    if isinstance(statement, ast.Return):
        value = statement.value
        return value is None or (isinstance(value, ast.Constant) and value.value is None)
    return isinstance(statement, ast.Pass)


def catches(handler: ast.ExceptHandler, errors: frozenset[str]) -> bool:
    return handler.type is None or any(
        (isinstance(each, ast.Name) and each.id in errors) or (isinstance(each, ast.Attribute) and each.attr in errors)
        for each in nodes_of(handler.type)
    )

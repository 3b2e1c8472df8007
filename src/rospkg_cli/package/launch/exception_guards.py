"""Where a Python file catches the exception for a missing package or file, or asks first whether it is there."""

from __future__ import annotations

import ast
from collections.abc import Collection, Iterator, Mapping

from ...languages.python.file import PythonFile, asked
from ...languages.python.guarded_nodes import suppresses
from ...languages.python.nodes import functions_of, last_name, nodes_of, nodes_of_kind
from ...source import Span

MISSING = frozenset({"PackageNotFoundError", "LookupError", "KeyError", "Exception", "BaseException"})
"""What ament_index raises where a package is not there, and what takes it."""

LOOKUPS = frozenset({"get_package_share_directory", "get_package_share_path", "get_package_prefix", "FindPackageShare"})

BRANCHING = frozenset({
    ast.Module, ast.FunctionDef, ast.AsyncFunctionDef, ast.ClassDef, ast.If, ast.IfExp, ast.For, ast.AsyncFor,
    ast.While, ast.With, ast.AsyncWith, ast.Try, ast.ExceptHandler, ast.match_case, getattr(ast, "TryStar", ast.Try),
})  # fmt: skip
"""The classes of nodes with conditions, or with lists of statements."""

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


def catches(handler: ast.ExceptHandler, errors: frozenset[str]) -> bool:
    return handler.type is None or any(
        (isinstance(each, ast.Name) and each.id in errors) or (isinstance(each, ast.Attribute) and each.attr in errors)
        for each in nodes_of(handler.type)
    )

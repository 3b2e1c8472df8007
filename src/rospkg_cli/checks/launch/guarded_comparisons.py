"""Comparisons for plain values only, where the code around them handles launch substitutions itself (LCH014)."""

from __future__ import annotations

import ast
from collections.abc import Iterable, Iterator

from ...languages.python.file import PythonFile
from ...languages.python.nodes import FunctionNode, functions_of, last_name, nodes_of, nodes_of_kind
from ...package.launch.evaluated_launch import SubstitutionUse

ASKS = frozenset({"isinstance", "hasattr", "type"})
"""Functions that ask for the type of a value."""
LEAVES = (ast.Return, ast.Raise, ast.Continue, ast.Break)


def is_guarded(use: SubstitutionUse, file: PythonFile) -> bool:
    """Return whether the code performs a substitution where comparing it does not decide.

    A helper may take `True` as well as a substitution: `param == True or param.perform(context) == 'true'`. For a
    value that the file itself makes a substitution, only such an `or` counts.
    """
    for node in nodes_of_kind(file.tree, ast.Compare):
        if file.span(node) == use.span:
            names = [each.id for each in (node.left, *node.comparators) if isinstance(each, ast.Name)]
            laws = (is_made_up_for, is_for_plain_values)
            return any(law(node, name, use, file) for law in laws for name in names)
    return False


def is_made_up_for(compared: ast.Compare, name: str, use: SubstitutionUse, file: PythonFile) -> bool:
    """Return whether the `or` around an `==`, or the `and` around a `!=`, performs what is compared."""
    joining = ast.Or if use.name == "==" else ast.And
    joined = (each for each in nodes_of_kind(file.tree, ast.BoolOp) if isinstance(each.op, joining))
    return any(compared in each.values and has_call(each.values, name) for each in joined)


def is_for_plain_values(compared: ast.Compare, name: str, use: SubstitutionUse, file: PythonFile) -> bool:
    """Return whether a function asks for the type of its own value, or performs it where it differs from the other."""
    around = [each for each in functions_of(file.tree) if compared in nodes_of(each)]
    if not around:
        return False
    inner = min(around, key=lambda each: len(nodes_of(each)))
    if not is_given(name, inner) and is_made_here(name, use, file):
        return False
    return has_call([inner], name, ASKS) or has_call(reached(compared, use.name, inner), name)


def is_given(name: str, function: FunctionNode) -> bool:
    given = function.args
    every = [*given.posonlyargs, *given.args, *given.kwonlyargs]
    return any(each.arg == name for each in every)


def is_made_here(name: str, use: SubstitutionUse, file: PythonFile) -> bool:
    """Return whether a name is bound to the very substitution that is compared."""
    made = {each.span for each in use.operands}
    bound = (each for each in nodes_of_kind(file.tree, ast.Assign) if file.span(each.value) in made)
    return any(isinstance(target, ast.Name) and target.id == name for each in bound for target in each.targets)


def reached(compared: ast.Compare, operator: str, function: FunctionNode) -> Iterator[ast.AST]:
    """Yield the nodes that Python reaches only where the two compared values differ."""
    for node in nodes_of(function):
        if not isinstance(node, ast.If | ast.IfExp) or compared not in nodes_of(node.test):
            continue
        unlike = node.orelse if operator == "==" else node.body
        yield from unlike if isinstance(unlike, list) else [unlike]
        if isinstance(node, ast.If) and operator == "==" and isinstance(node.body[-1], LEAVES):
            yield from following(node, function)


def following(node: ast.If, function: FunctionNode) -> Iterator[ast.stmt]:
    """Yield the statements behind an `if` that leaves the function or the loop."""
    end = node.end_lineno or node.lineno
    yield from (each for each in nodes_of(function) if isinstance(each, ast.stmt) and each.lineno > end)


def has_call(nodes: Iterable[ast.AST], name: str, functions: frozenset[str] = frozenset()) -> bool:
    """Return whether one of some functions is called with a name; with no functions, whether the name is performed."""
    for node in (each for root in nodes for each in nodes_of(root)):
        if not isinstance(node, ast.Call):
            continue
        called = last_name(node.func)
        if called in functions or (not functions and called.startswith("perform")):
            parts = [node.func, *node.args, *(each.value for each in node.keywords)]
            if any(isinstance(each, ast.Name) and each.id == name for part in parts for each in nodes_of(part)):
                return True
    return False

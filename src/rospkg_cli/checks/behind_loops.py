"""Places that run only after a loop in a constructor, in which the program does its work until it is stopped."""

from __future__ import annotations

import ast
from collections.abc import Iterator, Sequence

from ..languages.python.attributes import is_of_self
from ..languages.python.evaluation_order import in_order
from ..languages.python.file import PythonFile
from ..languages.python.nodes import FunctionNode, nodes_of
from ..source import Span
from .python.behind_spin import CATCHES, LASTING
from .shown.meanings import Meanings, Own

ENDING = frozenset({"shutdown", "try_shutdown", "exit", "_exit", "destroy_node"})
"""Calls behind which a `break` ends the program."""
HOLDING = ast.Expr | ast.Assign | ast.AnnAssign
BLOCKS = ("body", "orelse", "finalbody")


def is_behind_loop(meanings: Meanings, file: PythonFile, span: Span) -> bool:
    """Return whether a place runs only after the endless loop in the constructor of an object has ended."""
    for block in blocks_of(file.tree):
        at = next((number for number, each in enumerate(block) if file.span(each).holds(span)), None)
        if at is None:
            continue
        if any(stays(meanings, file, each) for each in block[:at]) or is_evaluated_late(
            meanings, file, block[at], span
        ):
            return True
    return False


def is_evaluated_late(meanings: Meanings, file: PythonFile, statement: ast.stmt, span: Span) -> bool:
    """Return whether a part of a statement is evaluated behind one that stays in a loop: the target of `a.b = A()`."""
    if not isinstance(statement, HOLDING):
        return False
    parts = [each for each in in_order(statement) if isinstance(each, ast.expr)]
    at = next((number for number, each in enumerate(parts) if file.span(each).holds(span)), 0)
    return any(stays(meanings, file, each) for each in parts[:at])


def stays(meanings: Meanings, file: PythonFile, node: ast.AST) -> bool:
    """Return whether a statement or a value makes an object whose constructor loops for good."""
    value = node.value if isinstance(node, HOLDING) else node
    return isinstance(value, ast.Call) and makes_looping(meanings, file, value)


def makes_looping(meanings: Meanings, file: PythonFile, call: ast.Call) -> bool:
    definition = meanings.of(file, call.func)
    return definition is not None and isinstance(definition.node, ast.ClassDef) and is_looping(definition)


def is_looping(owner: Own) -> bool:
    """Return whether the constructor of a class comes straight to a loop that only the end of the program ends."""
    body = owner.node.body if isinstance(owner.node, ast.ClassDef) else []
    methods = {each.name: each for each in body if isinstance(each, ast.FunctionDef) and not each.decorator_list}
    waiting = [methods["__init__"]] if "__init__" in methods else []
    for method in waiting:
        for each in straight(method.body):
            if isinstance(each, ast.While) and is_endless(each):
                return True
            match each:
                case ast.Expr(value=ast.Call(func=called)) if is_of_self(called) and called.attr in methods:
                    waiting += [methods[called.attr]] if methods[called.attr] not in waiting else []
    return False


def straight(body: Sequence[ast.stmt]) -> Iterator[ast.stmt]:
    """Yield the statements that run one after the other, those of `try` and `with` among them."""
    for each in body:
        if isinstance(each, ast.Try | ast.With):
            yield from straight(each.body)
            continue
        yield each
        if any(isinstance(node, ast.Return | ast.Raise) for node in nodes_of(each)):
            return


def is_endless(loop: ast.While) -> bool:
    return ast.unparse(loop.test) in LASTING and not leaves(loop.body)


def leaves(block: Sequence[ast.stmt], *, is_inner: bool = False) -> bool:
    """Return whether the program may go on behind the loop of a block: by a `break`, but behind `rclpy.shutdown()`."""
    for each in block:
        match each:
            case ast.Expr(value=ast.Call(func=ast.Attribute(attr=name) | ast.Name(id=name))) if name in ENDING:
                return False
            case ast.Return() | ast.Raise():
                return True
            case ast.Break():
                return not is_inner
        inner = is_inner or isinstance(each, ast.For | ast.AsyncFor | ast.While)
        if any(leaves(one, is_inner=inner) for one in blocks_in(each)):
            return True
    return False


def blocks_in(statement: ast.stmt) -> Iterator[Sequence[ast.stmt]]:
    """Yield the blocks of a statement that run with it, but for what Ctrl-C leads to."""
    if not isinstance(statement, FunctionNode | ast.ClassDef):
        yield from (getattr(statement, name, ()) for name in BLOCKS)
        yield from (each.body for each in getattr(statement, "handlers", ()) if not is_for_interrupt(each))
        yield from (each.body for each in getattr(statement, "cases", ()))


def is_for_interrupt(handler: ast.ExceptHandler) -> bool:
    return handler.type is not None and any(name in ast.unparse(handler.type) for name in CATCHES)


def blocks_of(tree: ast.Module) -> Iterator[Sequence[ast.stmt]]:
    for node in nodes_of(tree):
        if isinstance(node, ast.Module | ast.stmt | ast.ExceptHandler | ast.match_case):
            yield from (block for name in BLOCKS if (block := getattr(node, name, ())))

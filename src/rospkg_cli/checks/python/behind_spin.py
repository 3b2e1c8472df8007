"""Places in Python code that are reached only once a node that spins ends by itself."""

from __future__ import annotations

import ast
from collections.abc import Callable, Iterable, Iterator, Sequence

from ...languages.python.file import PythonFile
from ...languages.python.nodes import FunctionNode, nodes_of, nodes_of_kind
from ...languages.python.stopped_places import StoppedPlaces
from ...source import Span

SPIN = "spin"
"""`rclpy.spin(node)`, `executor.spin()`: Ctrl-C leaves both by KeyboardInterrupt, or ExternalShutdownException."""
LASTING = frozenset({"True", "1", "rclpy.ok()"})
CATCHES = ("KeyboardInterrupt", "BaseException", "ExternalShutdownException")


def is_behind_spin(file: PythonFile, span: Span) -> bool:
    """Return whether a place follows a call of `spin`, or a loop for as long as ROS runs, that no `try` shields."""
    for block in blocks(file.tree):
        at = next((number for number, each in enumerate(block) if file.span(each).holds(span)), 0)
        if any(is_left_by_interrupt(each) for each in block[:at]):
            return True
    return False


def called_behind_spin(file: PythonFile, is_taken: Callable[[str], bool]) -> StoppedPlaces | None:
    """Return the places that are led to behind such a call alone, in functions too; None where there is none.

    Other files may lead to what they take.
    """
    spins = (each for block in blocks(file.tree) for each in block[:-1] if is_left_by_interrupt(each))
    spans = tuple(map(file.span, spins))
    return StoppedPlaces(file, spans, is_taken, is_lasting=True) if spans else None


def is_called_late(files: Iterable[PythonFile], file: PythonFile, span: Span) -> bool:
    """Return whether a place is in a method that files call behind a `spin` alone, the file of the class or another.

    Files that do not name the class mean the method of another object.
    """
    for owner in nodes_of_kind(file.tree, ast.ClassDef):
        for method in owner.body:
            if isinstance(method, ast.FunctionDef) and file.span(method).holds(span):
                naming = (each for each in files if each is file or owner.name in each.source.text)
                uses = ((each, node) for each in naming for node in nodes_of_kind(each.tree, ast.Attribute))
                named = [(each, each.span(node)) for each, node in uses if node.attr == method.name]
                outside = [(each, at) for each, at in named if each is not file or not file.span(method).holds(at)]
                return bool(outside) and all(is_behind_spin(each, at) for each, at in outside)
    return False


def blocks(tree: ast.Module) -> Iterator[Sequence[ast.stmt]]:
    for node in nodes_of(tree):
        for name in ("body", "orelse", "finalbody"):
            block = getattr(node, name, None)
            if isinstance(block, list) and len(block) > 1:
                yield block


def is_left_by_interrupt(statement: ast.stmt) -> bool:
    """Return whether a statement lasts until somebody stops the program, and hands the exception on."""
    match statement:
        case ast.Expr(value=ast.Call(func=ast.Attribute(attr=name))):
            return name == SPIN
        case ast.While():
            is_left = has_own_break(statement) or has_catch(statement)
            return ast.unparse(statement.test) in LASTING and not is_left
        case ast.With(body=body):
            return any(is_left_by_interrupt(each) for each in body)
        case ast.Try(body=body, handlers=handlers):
            return not any(catches(each) for each in handlers) and any(is_left_by_interrupt(each) for each in body)
    return False


def has_own_break(loop: ast.While) -> bool:
    """Return whether a `break` ends the loop itself, and not one of a loop inside of it."""
    waiting: list[ast.AST] = [*loop.body]
    while waiting:
        node = waiting.pop()
        if isinstance(node, ast.Break):
            return True
        if isinstance(node, ast.For | ast.AsyncFor | ast.While):
            waiting += node.orelse
        elif not isinstance(node, FunctionNode | ast.ClassDef):
            waiting += ast.iter_child_nodes(node)
    return False


def has_catch(loop: ast.While) -> bool:
    return any(catches(each) for each in nodes_of_kind(loop, ast.ExceptHandler))


def catches(handler: ast.ExceptHandler) -> bool:
    """Return whether a handler takes what Ctrl-C raises."""
    return handler.type is None or any(name in ast.unparse(handler.type) for name in CATCHES)

"""Statements of Python code that always raise, as a place in a branch of them does that is always come to."""

from __future__ import annotations

import ast
from collections.abc import Callable

from ...source import Span
from .constant_truth import constant_truth, unreached_statements
from .file import PythonFile
from .nodes import FunctionNode, last_name, nodes_of, nodes_of_kind
from .raising_regions import BLOCKS, BRANCHES, around
from .settled_names import settled_in, truths
from .started_calls import STARTERS

Scope = FunctionNode | ast.Module
INTERRUPTS = frozenset({"KeyboardInterrupt", "SystemExit", "GeneratorExit", "ExternalShutdownException"})
"""What a program is stopped by: no fault of a line is one of these."""
LASTING = frozenset({"True", "1", "rclpy.ok()"})


def raising_statement(file: PythonFile, scope: Scope, stop: Span, is_taken: Callable[[str], bool]) -> Span | None:
    """Return the statement around a place that always raises, which so raises too; other files may set some names.

    These are a `try` that does not catch it, an `if` that is known to hold, and a loop that is always begun.
    """
    found = [
        (held.start, each, name)
        for each in nodes_of(scope)
        for name in (BLOCKS if isinstance(each, BRANCHES) else ())
        if (block := getattr(each, name, None)) and (held := around(file, block)).holds(stop)
    ]
    if not found:
        return None
    _, inner, name = max(found, key=lambda each: each[0])
    match inner:
        case ast.If(test=test):
            passes = truth_in(scope, file, test, is_taken) is (name == "body")
        case ast.While(test=test):
            is_left = any(isinstance(each, ast.Break | ast.Continue) for each in nodes_of(inner))
            passes = name == "body" and ast.unparse(test) in LASTING and not is_left
        case ast.Try(body=body, handlers=handlers):
            may_be_stopped = any(lasts(each) for each in body if file.span(each).start < stop.start)
            is_swallowed = any(isinstance(node, ast.Return) for each in inner.finalbody for node in nodes_of(each))
            passes = name == "body" and not may_be_stopped and not is_swallowed and all(map(is_for_stops, handlers))
        case _:
            return None
    return file.span(inner) if passes else None


def truth_in(scope: Scope, file: PythonFile, test: ast.expr, is_taken: Callable[[str], bool]) -> bool | None:
    """Return what a condition of a scope always is, by names that hold known values; None where that is unknown."""
    constants = {name: value for name, value in file.constants.items() if not is_taken(name)}
    idle = [*unreached_statements(nodes_of(scope), constants)]
    values = settled_in(scope, file, idle) if not isinstance(scope, ast.Module) else {}
    return constant_truth(test, {**constants, **truths([test], values)})


def lasts(statement: ast.stmt) -> bool:
    """Return whether a statement may last until somebody stops the program."""
    calls = (each.func for each in nodes_of_kind(statement, ast.Call))
    names = map(last_name, calls)
    return (
        isinstance(statement, ast.While)
        or bool(nodes_of_kind(statement, ast.While))
        or any(name in STARTERS for name in names)
    )


def is_for_stops(handler: ast.ExceptHandler) -> bool:
    """Return whether a handler takes what stops a program, and nothing else."""
    match handler.type:
        case ast.Tuple(elts=kinds):
            return all(ast.unparse(each).rpartition(".")[2] in INTERRUPTS for each in kinds)
        case ast.Name() | ast.Attribute() as kind:
            return ast.unparse(kind).rpartition(".")[2] in INTERRUPTS
    return False

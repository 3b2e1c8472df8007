"""The callbacks that an executor alone calls, once something spins their node."""

from __future__ import annotations

import ast
from collections.abc import Iterable, Iterator

from ...languages.python.counted_conditions import Counted
from ...languages.python.file import PythonFile
from ...languages.python.nodes import last_name, nodes_of, nodes_of_kind

PLACES = {"create_subscription": 2, "create_timer": 1, "create_service": 2, "ActionServer": 3, "send_goal_async": 1}
"""Calls that are given a callback, with its position."""
ENDING = ("callback",)
DONE = "add_done_callback"
ANSWERED = frozenset({"send_goal_async", "call_async", "get_result_async", "cancel_goal_async"})
"""Methods whose futures an executor ends; others may be of threads."""


def without_callbacks(parts: Iterable[Counted], file: PythonFile) -> Iterator[Counted]:
    """Yield the nodes of a unit, each before its parts, without calls that register callbacks, and without these."""
    left_out: set[int] = set()
    for node, conditions in parts:
        given = callbacks(node, file) if isinstance(node, ast.Call) else []
        left_out.update(id(inner) for each in given for inner in nodes_of(each))
        if not given and id(node) not in left_out:
            yield node, conditions


def callbacks(call: ast.Call, file: PythonFile) -> list[ast.expr]:
    """Return the callbacks that a call hands to an executor: functions, methods, `lambda` and `partial`."""
    name = last_name(call.func)
    if name == DONE and isinstance(call.func, ast.Attribute) and is_answer(call.func.value, file):
        given = [*call.args[:1], *(each.value for each in call.keywords)]
    elif name in PLACES:
        at = PLACES[name]
        given = [*call.args[at : at + 1]]
        given += [each.value for each in call.keywords if each.arg is not None and each.arg.endswith(ENDING)]
    else:
        return []
    return [each for each in given if is_function(each)]


def is_function(node: ast.expr) -> bool:
    is_partial = isinstance(node, ast.Call) and last_name(node.func) == "partial"
    return is_partial or isinstance(node, ast.Name | ast.Attribute | ast.Lambda)


def is_answer(receiver: ast.expr, file: PythonFile) -> bool:
    """Return whether an expression is a future that is ended by an answer alone, wherever the file sets it."""
    if isinstance(receiver, ast.Call):
        return last_name(receiver.func) in ANSWERED
    text = ast.unparse(receiver)
    stores = (each for each in nodes_of_kind(file.tree, ast.Assign) if text in map(ast.unparse, each.targets))
    given = [each.value for each in stores]
    return bool(given) and all(isinstance(each, ast.Call) and is_answer(each, file) for each in given)

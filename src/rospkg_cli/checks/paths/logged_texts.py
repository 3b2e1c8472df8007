"""Texts that code only says: the arguments of logs and of `print`."""

from __future__ import annotations

import ast

from ...languages.python.file import PythonFile
from ...languages.python.nodes import nodes_of, nodes_of_kind
from ...source import Span

LOGS = frozenset("print debug info warn warning error fatal critical exception".split())


def logged_texts(file: PythonFile) -> frozenset[int]:
    """Return the identity of each node in a call that says something, as `self.get_logger().info(…)`."""
    known = vars(file)
    if "logged_texts" not in known:
        calls = (call for call in nodes_of_kind(file.tree, ast.Call) if is_log(call))
        known["logged_texts"] = frozenset(id(each) for call in calls for each in nodes_of(call))
    found: frozenset[int] = known["logged_texts"]
    return found


def logged_spans(file: PythonFile) -> list[Span]:
    """Return the calls that say something."""
    return [file.span(call) for call in nodes_of_kind(file.tree, ast.Call) if is_log(call)]


def is_said(file: PythonFile, span: Span) -> bool:
    """Return whether a place is a text that code only says: in a log, or as the message of what it raises."""
    raised = (file.span(each.exc) for each in nodes_of_kind(file.tree, ast.Raise) if each.exc is not None)
    return any(each.holds(span) for each in (*logged_spans(file), *raised))


def is_log(call: ast.Call) -> bool:
    match call.func:
        case ast.Attribute(attr=name) | ast.Name(id=name):
            return name in LOGS
    return False

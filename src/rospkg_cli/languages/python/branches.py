"""Whether a place runs only under a condition, or where nothing else is given."""

from __future__ import annotations

import ast
from collections.abc import Iterator, Sequence

from ...source import Span
from .certain_nodes import is_guard
from .file import PythonFile
from .nodes import FunctionNode, children_of, last_name, nodes_below, nodes_of, nodes_of_kind
from .syntax import PositionedNode

HOW_STARTED = frozenset({"__name__", "__package__", "__spec__"})
STANDING_IN = frozenset({"default", "default_value", "value"})
"""Arguments that count where nothing else is given: `add_argument('--map', default=…)`."""
SECOND = frozenset({"declare_parameter", "get", "getenv", "getattr", "get_parameter_or", "setdefault", "pop"})
"""Functions whose second argument does."""


def is_under_condition(file: PythonFile, span: Span) -> bool:
    """Return whether a place is in a branch, a handler or a guarded loop of the function around it, or of the file."""
    around = [each for each in nodes_of(file.tree) if isinstance(each, FunctionNode) and file.span(each).holds(span)]
    inner = max(around, key=lambda each: file.span(each).start, default=None)
    nodes = nodes_below(inner) if inner is not None else of_module(file)
    return any(file.span(part).holds(span) for node in nodes for part in guarded(node))


def of_module(file: PythonFile) -> Iterator[ast.AST]:
    """Yield the nodes of a file that are in no function, nor ask whether the file is the program."""
    waiting: list[ast.AST] = [*file.tree.body]
    while waiting:
        node = waiting.pop()
        if not isinstance(node, FunctionNode):
            waiting += children_of(node)
            yield from [] if isinstance(node, ast.If) and is_guard(node) else [node]


def guarded(node: ast.AST) -> Sequence[PositionedNode]:
    """Return what runs only under a condition; a loop for as long as ROS runs has none."""
    match node:
        case ast.If() | ast.IfExp():
            parts = node.body, node.orelse
            return [each for part in parts for each in (part if isinstance(part, list) else [part])]
        case ast.BoolOp():
            return node.values[1:]
        case ast.While(test=ast.UnaryOp() | ast.Compare()) | ast.ExceptHandler() | ast.match_case():
            return node.body
    return ()


def asks_how_started(file: PythonFile, span: Span) -> bool:
    """Return whether a place is under a condition on how the file is started: `__name__`, `__package__`."""
    asking = (each for each in file.tree.body if isinstance(each, ast.If) and HOW_STARTED & names_in(each.test))
    return any(file.span(part).holds(span) for each in asking for part in (*each.body, *each.orelse))


def names_in(node: ast.expr) -> set[str]:
    return {each.id for each in nodes_of(node) if isinstance(each, ast.Name)}


def is_default(file: PythonFile, span: Span) -> bool:
    """Return whether a place is in what counts where nothing else is given: a parameter, an option, an argument."""
    return any(file.span(part).holds(span) for part in defaults(file))


def defaults(file: PythonFile) -> Iterator[PositionedNode]:
    for call in nodes_of_kind(file.tree, ast.Call):
        name = last_name(call.func)
        yield from (each.value for each in call.keywords if each.arg in STANDING_IN)
        yield from call.args[1:] if name in SECOND else ()
    for owner in nodes_of(file.tree):
        if isinstance(owner, FunctionNode):
            yield from (each for each in (*owner.args.defaults, *owner.args.kw_defaults) if each is not None)

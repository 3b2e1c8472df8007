"""Actions that event handlers of a Python launch file wait for, and that nothing starts (LCH018)."""

from __future__ import annotations

import ast
from collections import Counter
from collections.abc import Collection, Iterable, Iterator
from itertools import chain

from ...languages.python.file import PythonFile
from ...languages.python.nodes import nodes_of
from ...languages.python.unread_values import is_stored, never_added
from ...light_dataclasses import dataclass

TARGETS = frozenset({"target_action", "target_lifecycle_node"})
ELSEWHERE = frozenset({"locals", "vars", "eval", "exec", "globals"})


@dataclass(frozen=True, slots=True)
class AwaitedAction:
    name: str
    target: ast.Name
    """Where the name is bound."""
    value: ast.expr
    is_vain: bool
    """Whether all that its handlers hold is added by itself, too: it starts at once."""


def only_awaited(file: PythonFile) -> Iterator[AwaitedAction]:
    """Yield what a function binds to a name that is read as the target of handlers alone."""
    nodes = list(nodes_of(file.tree))
    loads = [node for node in nodes if isinstance(node, ast.Name) and not is_stored(node)]
    targets = {id(node.value) for node in nodes if isinstance(node, ast.keyword) and node.arg in TARGETS}
    others = {node.id for node in loads if id(node) not in targets}
    idle = tuple(never_added(file))
    awaited = {
        node.id for node in loads if id(node) in targets and not any(each.contains(file.span(node)) for each in idle)
    }
    started = started_anyway(nodes, others)
    for function in nodes if awaited and others.isdisjoint(ELSEWHERE) else ():
        for node in nodes_of(function) if isinstance(function, ast.FunctionDef) else ():
            match node:
                case ast.Assign(targets=[ast.Name(id=name) as target], value=value) if name in awaited - others:
                    yield AwaitedAction(name, target, value, name in started)


def started_anyway(nodes: Iterable[ast.AST], others: Collection[str]) -> frozenset[str]:
    """Return the targets of which all handlers hold nothing but actions that are read outside of handlers too."""
    held: dict[str, list[ast.expr]] = {}
    for node in nodes:
        keywords = node.keywords if isinstance(node, ast.Call) else []
        values = [each.value for each in keywords if each.arg not in TARGETS]
        for each in keywords:
            if each.arg in TARGETS and isinstance(each.value, ast.Name):
                held.setdefault(each.value.id, []).extend(values)
    inside = Counter(each.id for value in chain(*held.values()) for each in names_of(value))
    everywhere = Counter(each.id for each in nodes if isinstance(each, ast.Name) and not is_stored(each))
    added = {name for name in others if everywhere[name] > inside[name]}
    return frozenset(
        name for name, values in held.items() if values and all(is_of_names(each, added) for each in values)
    )


def names_of(value: ast.expr) -> list[ast.Name]:
    return [node for node in nodes_of(value) if isinstance(node, ast.Name)]


def is_of_names(value: ast.expr, added: Collection[str]) -> bool:
    """Return whether a value is one of some names, or a list of them."""
    items = value.elts if isinstance(value, ast.List | ast.Tuple) else [value]
    return bool(items) and all(isinstance(each, ast.Name) and each.id in added for each in items)

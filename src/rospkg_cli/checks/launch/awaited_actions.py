"""Actions that event handlers of a Python launch file wait for, and that nothing starts (LCH018)."""

from __future__ import annotations

import ast
from collections.abc import Iterator

from ...languages.python.file import PythonFile
from ...languages.python.nodes import nodes_of
from ...languages.python.unread_values import is_stored, never_added

TARGETS = frozenset({"target_action", "target_lifecycle_node"})
ELSEWHERE = frozenset({"locals", "vars", "eval", "exec", "globals"})


def only_awaited(file: PythonFile) -> Iterator[tuple[str, ast.expr, ast.expr]]:
    """Yield what a function binds to a name that is read as the target of handlers alone, with the name's node."""
    nodes = list(nodes_of(file.tree))
    loads = [node for node in nodes if isinstance(node, ast.Name) and not is_stored(node)]
    targets = {id(node.value) for node in nodes if isinstance(node, ast.keyword) and node.arg in TARGETS}
    others = {node.id for node in loads if id(node) not in targets}
    idle = tuple(never_added(file))
    awaited = {
        node.id for node in loads if id(node) in targets and not any(each.contains(file.span(node)) for each in idle)
    }
    for function in nodes if awaited and others.isdisjoint(ELSEWHERE) else ():
        for node in nodes_of(function) if isinstance(function, ast.FunctionDef) else ():
            match node:
                case ast.Assign(targets=[ast.Name(id=name) as target], value=value) if name in awaited - others:
                    yield name, target, value

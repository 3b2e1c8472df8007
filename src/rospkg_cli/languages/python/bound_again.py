"""Values of a function that the same name is bound away from before anything reads them: `a = Node(…)`, twice."""

from __future__ import annotations

import ast
from collections.abc import Iterator

from ...light_dataclasses import dataclass
from .file import PythonFile
from .nodes import nodes_below, nodes_of_kind


@dataclass(frozen=True, slots=True)
class BoundAgain:
    target: ast.Name
    value: ast.expr
    again: ast.Assign
    """The statement that binds the name to something else."""


def bound_again(file: PythonFile) -> Iterator[BoundAgain]:
    """Yield what the statements of a function bind one after the other, with no read between; no branches."""
    for function in nodes_of_kind(file.tree, ast.FunctionDef):
        waiting: dict[str, tuple[ast.Name, ast.expr]] = {}
        for statement in function.body:
            below = [node for node in nodes_below(statement) if isinstance(node, ast.Name)]
            bound = statement.targets[0] if isinstance(statement, ast.Assign) and len(statement.targets) == 1 else None
            for node in below:
                if node is not bound:  # read, deleted, or bound somewhere inside
                    waiting.pop(node.id, None)
            if isinstance(statement, ast.Assign) and isinstance(bound, ast.Name):
                target, value = waiting.get(bound.id, (None, None))
                if target is not None and value is not None and ast.dump(value) != ast.dump(statement.value):
                    yield BoundAgain(target, value, statement)
                waiting[bound.id] = bound, statement.value

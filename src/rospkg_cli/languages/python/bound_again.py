"""Values of a function that the same name is bound away from before anything reads them: `a = Node(…)`, twice."""

from __future__ import annotations

import ast
from collections.abc import Iterator

from ...light_dataclasses import dataclass
from .attributes import is_of_self
from .file import PythonFile
from .nodes import nodes_below, nodes_of_kind

PLAIN_CALLS = frozenset({"declare_parameter", "declare_parameters", "get_parameter", "get_logger", "get_clock"})
"""Methods of a node that read no member of its heirs."""


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


def members_bound_again(file: PythonFile) -> Iterator[ast.expr]:
    """Yield what a method gives to a member that it binds again in a later statement, with no read or call of `self`
    between; no branches.
    """
    for function in nodes_of_kind(file.tree, ast.FunctionDef):
        waiting: dict[str, ast.expr] = {}
        for statement in function.body:
            match statement:
                case ast.Assign(targets=[ast.Attribute(value=ast.Name(id="self"), attr=bound)], value=value):
                    below = [value, *nodes_below(value)]
                case _:
                    bound, below = "", [*nodes_below(statement)]
            selves = [each for each in below if isinstance(each, ast.Attribute) and is_of_self(each)]
            called = {id(each.func) for each in below if isinstance(each, ast.Call)}
            bare = sum(isinstance(each, ast.Name) and each.id == "self" for each in below) - len(selves)
            if bare or any(id(each) in called and each.attr not in PLAIN_CALLS for each in selves):
                waiting.clear()  # what gets the object may read it
            for each in selves:
                waiting.pop(each.attr, None)
            if isinstance(statement, ast.Assign) and bound:
                if bound in waiting:
                    yield waiting[bound]
                waiting[bound] = statement.value

"""Which variables of a function always hold one message, and which message an expression evaluates to."""

from __future__ import annotations

import ast
from collections.abc import Callable, Iterator, Mapping

from ...languages.python.nodes import nodes_of
from .message_classes import MessageClasses
from .variable_bindings import Bindings, name_of

Fields = Callable[[str], Mapping[str, str] | None]
"""Returns the fields of a message, each with the message that it holds; None for an unknown message."""
ASKS = frozenset({"isinstance", "hasattr", "getattr", "setattr", "type"})
"""Functions that code calls where a variable may hold values of several types."""
FUTURES = frozenset({"result", "send_goal", "send_goal_async", "get_result", "get_result_async"})
OF_ACTIONS = ("_Goal", "_Result", "_Feedback")
PASSES = 3
"""How often assignments are evaluated again, for variables that are assigned from others."""

Environment = Mapping[str, str]
"""The message that each variable holds: `msg`, `self.msg`."""


def held_by(node: ast.expr | None, variables: Environment, classes: MessageClasses, fields: Fields) -> str:
    """Return the message that an expression evaluates to; "" where that is unknown."""
    if node is None:
        return ""
    if (name := name_of(node)) in variables:
        return variables[name]
    if isinstance(node, ast.Call):
        return classes.message(node.func)
    if isinstance(node, ast.Attribute) and (outer := held_by(node.value, variables, classes, fields)):
        return (fields(outer) or {}).get(node.attr, "")
    return ""


def variables_of(body: Bindings, given: Mapping[str, str], classes: MessageClasses, fields: Fields) -> dict[str, str]:
    """Return the variables that hold the same message wherever a body binds them; `given` are its parameters."""
    found: dict[str, str] = dict(given)
    for _ in range(PASSES):
        bound: dict[str, set[str]] = {name: {kind} for name, kind in given.items()}
        for name, value, annotation in body.values:
            kind = annotated(annotation, value, classes)
            bound.setdefault(name, set()).add(kind or held_by(value, found, classes, fields))
        before, found = (
            found,
            {n: next(iter(kinds)) for n, kinds in bound.items() if len(kinds) == 1 and "" not in kinds},
        )
        if found == before:
            break
    asked = set(asked_names(body.body)) if found else ()
    return {name: kind for name, kind in found.items() if name not in asked}


def annotated(annotation: ast.expr | None, value: ast.expr | None, classes: MessageClasses) -> str:
    """Return the message that an annotation names, or "".

    It is "" too for what a future of an action holds: rclpy gives the goal handle, or a message that wraps the result,
    whatever the annotation says.
    """
    kind = classes.message(annotation) if annotation is not None else ""
    given = value.value if isinstance(value, ast.Await) else value
    is_of_future = isinstance(given, ast.Call) and isinstance(given.func, ast.Attribute) and given.func.attr in FUTURES
    return "" if is_of_future and kind.endswith(OF_ACTIONS) else kind


def asked_names(body: list[ast.stmt]) -> Iterator[str]:
    """Yield the variables whose type or attributes, or whose fields' types, a body asks for (`hasattr(msg.a, …)`)."""
    for statement in body:
        for node in nodes_of(statement):
            if isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id in ASKS and node.args:
                yield from outer_names(node.args[0])


def outer_names(node: ast.expr) -> Iterator[str]:
    """Yield the variables that an expression is a part of: `msg` for `msg.header.stamp`."""
    while isinstance(node, ast.Attribute | ast.Subscript):
        yield name_of(node)
        node = node.value
    yield name_of(node)


def attributes_of(
    owner: ast.ClassDef, functions: list[tuple[Bindings, Environment]], classes: MessageClasses, fields: Fields
) -> dict[str, str]:
    """Return the attributes of `self` that hold the same message wherever a class binds them."""
    bound: dict[str, set[str]] = {}
    for function, variables in functions:
        local = {name: kind for name, kind in variables.items() if "." not in name}
        for name, value, annotation in function.values:
            if name.startswith("self."):
                kind = annotated(annotation, value, classes)
                bound.setdefault(name, set()).add(kind or held_by(value, local, classes, fields))
    for each in owner.body:
        if isinstance(each, ast.Assign | ast.AnnAssign):
            for target in each.targets if isinstance(each, ast.Assign) else [each.target]:
                bound.setdefault(f"self.{name_of(target)}", set()).add("")
    return {name: next(iter(kinds)) for name, kinds in bound.items() if len(kinds) == 1 and "" not in kinds}

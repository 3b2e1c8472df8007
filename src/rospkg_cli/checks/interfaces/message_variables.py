"""Which variables of a function always hold one message, and what expressions made of them hold."""

from __future__ import annotations

import ast
from collections.abc import Callable, Iterator, Mapping

from ...languages.python.attributes import is_of_self
from ...languages.python.nodes import CHILDLESS, children_of, nodes_of
from .message_classes import MessageClasses

Fields = Callable[[str], Mapping[str, str] | None]
"""Returns the fields of a message with the messages that they hold."""
ENDS = CHILDLESS | {ast.FunctionDef, ast.AsyncFunctionDef, ast.ClassDef, ast.Lambda}
"""The classes of nodes that are not looked into: new scopes, and what holds nothing."""
BINDERS = frozenset({
    ast.Assign, ast.AnnAssign, ast.Name, ast.Attribute, ast.ExceptHandler, ast.MatchAs, ast.MatchStar, ast.Global,
    ast.Nonlocal, ast.FunctionDef, ast.AsyncFunctionDef, ast.ClassDef,
})  # fmt: skip
"""The classes of nodes that may bind a variable."""
NAMES = (ast.Name, ast.Attribute)
PATTERNS = (ast.ExceptHandler, ast.MatchAs, ast.MatchStar)
SHARED = (ast.Global, ast.Nonlocal)
DEFINITIONS = (ast.FunctionDef, ast.AsyncFunctionDef, ast.ClassDef)
ASKS = frozenset({"isinstance", "hasattr", "getattr", "setattr", "type"})
FUTURES = frozenset({"result", "send_goal", "send_goal_async", "get_result", "get_result_async"})
OF_ACTIONS = ("_Goal", "_Result", "_Feedback")
PASSES = 3
"""How often assignments are followed, for variables made of others."""

Environment = Mapping[str, str]
"""The message that each variable holds: `msg`, `self.msg`."""


def own_nodes(body: list[ast.stmt]) -> list[ast.AST]:
    """Return the nodes of statements, without those in functions, classes and lambdas in them, level by level."""
    found: list[ast.AST] = []
    level: list[ast.AST] = [*body]
    while level:
        found += level
        level = [inner for node in level if node.__class__ not in ENDS for inner in children_of(node)]
    return found


class Bindings:
    """What a body binds: each variable with its value and its annotation, None for what is not known.

    None as a value is left out: what is done with it fails anyway. Worked out once for all who ask of a body.
    """

    def __init__(self, body: list[ast.stmt]) -> None:
        self.body = body
        self.nodes = own_nodes(body)
        self.values = tuple(bound_values([node for node in self.nodes if node.__class__ in BINDERS]))


def name_of(node: ast.AST) -> str:
    """Return `x` or `self.x`; "" for other expressions."""
    if isinstance(node, ast.Name):
        return node.id
    if is_of_self(node):
        return f"self.{node.attr}"
    return ""


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
    """Return the message that an annotation names; "" where rclpy gives an object of its own, which is often called so.

    What the futures of an action hold is the handle of the goal, or a message around the result.
    """
    kind = classes.message(annotation) if annotation is not None else ""
    given = value.value if isinstance(value, ast.Await) else value
    is_of_future = isinstance(given, ast.Call) and isinstance(given.func, ast.Attribute) and given.func.attr in FUTURES
    return "" if is_of_future and kind.endswith(OF_ACTIONS) else kind


def bound_values(nodes: list[ast.AST]) -> Iterator[tuple[str, ast.expr | None, ast.expr | None]]:
    """Yield what some nodes bind, as `Bindings` has it."""
    plain: set[int] = set()
    for node in nodes:
        if isinstance(node, ast.Assign) and len(node.targets) == 1 and (name := name_of(node.targets[0])):
            plain.add(id(node.targets[0]))
            if not (isinstance(node.value, ast.Constant) and node.value.value is None):
                yield name, node.value, None
        elif isinstance(node, ast.AnnAssign) and (name := name_of(node.target)):
            plain.add(id(node.target))
            yield name, node.value, node.annotation
    for node in nodes:
        if isinstance(node, NAMES):
            if not isinstance(node.ctx, ast.Load) and id(node) not in plain:
                yield name_of(node), None, None
        elif isinstance(node, PATTERNS):
            if node.name:
                yield node.name, None, None
        elif isinstance(node, SHARED):
            yield from ((name, None, None) for name in node.names)
        elif isinstance(node, DEFINITIONS):
            yield node.name, None, None


def asked_names(body: list[ast.stmt]) -> Iterator[str]:
    """Yield the variables of whose type or attributes a body asks, or of those of what is in them."""
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

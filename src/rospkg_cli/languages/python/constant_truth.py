"""Conditions of Python code that are always true or never on Linux, and the code that is never reached for them."""

from __future__ import annotations

import ast
from collections.abc import Iterable, Iterator, Mapping

from .linux_truth import holds_on_linux
from .nodes import last_name, nodes_of

ROS_VERSION = frozenset({"ROS_VERSION", "ros_version", "get_ros_version"})
"""How the number 1 or 2 is called of the ROS that a file for both runs in: a variable, or a function of the package."""

ENDING = frozenset({"sys.exit", "exit", "quit", "os._exit", "os.abort"})
"""Calls that do not return, in a statement of their own."""
LEAVING = ast.Return | ast.Raise | ast.Break | ast.Continue
BLOCKS = ("body", "orelse", "finalbody")


def constant_truth(test: ast.expr, names: Mapping[str, bool]) -> bool | None:
    """Return what a condition always is, None where that is unknown: `if False:`.

    Of some names it is known, and of comparisons of names with constants, by their text.
    """
    match test:
        case ast.Constant(value=value):
            return bool(value)
        case ast.Name(id=name):
            return names.get(name)
        case ast.Attribute(value=ast.Name(id="self"), attr=name) if f"self.{name}" in names:
            return names[f"self.{name}"]
        case ast.Compare(left=ast.Name() | ast.Attribute() | ast.Call(), ops=[_]) if (
            names and (text := ast.unparse(test)) in names
        ):
            return names[text]
        case ast.Compare(
            left=asked, ops=[ast.Eq() | ast.NotEq() as operator], comparators=[ast.Constant(value=value)]
        ) if asks_for_ros(asked):
            return (str(value) == "2") is isinstance(operator, ast.Eq) if str(value) in ("1", "2") else None
        case ast.Compare(left=ast.Constant(value="ROS_VERSION"), ops=[operator], comparators=[asked]) if is_environ(
            asked
        ):
            return True if isinstance(operator, ast.In) else False if isinstance(operator, ast.NotIn) else None
        case ast.UnaryOp(op=ast.Not(), operand=operand):
            inside = constant_truth(operand, names)
            return None if inside is None else not inside
        case ast.BoolOp(op=operator, values=values):
            decides = isinstance(operator, ast.Or)
            found = [constant_truth(each, names) for each in values]
            return decides if decides in found else None if None in found else not decides
    return holds_on_linux(test)


def asks_for_ros(value: ast.expr) -> bool:
    """Return whether a value is the number of the ROS: `ROS_VERSION`, `int(os.environ['ROS_VERSION'])`."""
    match value:
        case ast.Name(id=name) | ast.Attribute(attr=name):
            return name in ROS_VERSION
        case ast.Subscript(slice=ast.Constant(value=name)):
            return name in ROS_VERSION
        case ast.Call(func=function, args=arguments):
            named = [*arguments, function]
            return any(
                asks_for_ros(each) or (isinstance(each, ast.Constant) and each.value in ROS_VERSION) for each in named
            )
    return False


def is_environ(value: ast.expr) -> bool:
    return last_name(value) == "environ"


def unreached_nodes(body: Iterable[ast.AST], names: Mapping[str, bool]) -> Iterator[int]:
    """Yield the identity of each node in a branch that is never taken, or behind what leaves its block."""
    for each in unreached_statements(body, names):
        yield from map(id, nodes_of(each))


def unreached_statements(nodes: Iterable[ast.AST], names: Mapping[str, bool]) -> Iterator[ast.stmt]:
    """Yield the outer statements of branches that are never taken, and those behind a `raise` of the same block."""
    for node in nodes:
        if isinstance(node, ast.If) and (always := constant_truth(node.test, names)) is not None:
            yield from node.orelse if always else node.body
        for block in BLOCKS:
            statements = getattr(node, block, ())
            if isinstance(statements, list):  # a lambda has a body, too
                yield from behind_leaving(statements)


def behind_leaving(block: list[ast.stmt]) -> list[ast.stmt]:
    ends = (number for number, each in enumerate(block, start=1) if leaves(each))
    return block[next(ends, len(block)) :]


def leaves(statement: ast.stmt) -> bool:
    """Return whether nothing behind a statement of the same block runs."""
    match statement:
        case ast.Expr(value=ast.Call(func=function)):
            return isinstance(function, ast.Name | ast.Attribute) and ast.unparse(function) in ENDING
        case ast.If(body=body, orelse=other) if other:
            return any(map(leaves, body)) and any(map(leaves, other))
    return isinstance(statement, LEAVING)

"""Loops in which the constructor of a node waits for what only its own callbacks set: nothing spins it yet."""

from __future__ import annotations

import ast
from collections.abc import Iterator

from ...languages.python.attributes import is_of_self
from ...languages.python.counted_conditions import is_going
from ...languages.python.file import PythonFile
from ...languages.python.nodes import FunctionNode, nodes_of, nodes_of_kind
from ...languages.python.settled_names import Held, answer, constant_of
from ...ros.rclpy_names import members_of_nodes
from .node_bases import is_of_rclpy

IDLE = frozenset({"sleep", "print", "debug", "info", "warning", "warn", "error", "fatal"})
"""What the body of such a loop calls."""
REGISTERS = ("create_subscription", "create_timer", "create_service")
"""Methods of nodes whose callbacks an executor alone calls."""
KEEPS = frozenset({"super", "__init__", "ActionClient", "ActionServer", "Subscriber"})
"""Calls that are given the node, and do not spin it."""


def endless_waits(file: PythonFile) -> Iterator[tuple[ast.ClassDef, ast.While]]:
    """Yield the classes of nodes whose constructor never returns, each with the loop that it stays in."""
    if "while" not in file.source.text:
        return
    for owner in nodes_of_kind(file.tree, ast.ClassDef):
        if owner.bases and all(is_of_rclpy(file, base) for base in owner.bases):
            start = next((each for each in owner.body if isinstance(each, ast.FunctionDef) and is_start(each)), None)
            loop = first_wait(owner, start) if start is not None else None
            yield from [(owner, loop)] if loop is not None else []


def is_start(node: ast.FunctionDef) -> bool:
    return node.name == "__init__" and not node.decorator_list


def first_wait(owner: ast.ClassDef, start: ast.FunctionDef) -> ast.While | None:
    """Return the first loop of a constructor that waits for a member, where nothing that runs until then sets it."""
    for number, each in enumerate(start.body):
        if isinstance(each, ast.While) and not each.orelse and all(map(is_idle, each.body)):
            before = [node for one in start.body[:number] for node in nodes_of(one)]
            if not any(isinstance(node, ast.Return | ast.Raise) for node in before) and is_kept(before):
                run = run_until(owner, before)
                if run is not None and truth(each.test, values_before(start.body[:number], run)):
                    return each
    return None


def is_idle(statement: ast.stmt) -> bool:
    """Return whether a statement sleeps, logs, prints or passes."""
    match statement:
        case ast.Expr(value=ast.Call(func=ast.Name(id=name) | ast.Attribute(attr=name))):
            return name in IDLE
    return isinstance(statement, ast.Pass)


def is_kept(nodes: list[ast.AST]) -> bool:
    """Return whether some code hands the node itself to nothing that may spin it, nor keeps it elsewhere."""
    kept = {id(node.value) for node in nodes if isinstance(node, ast.Attribute)}
    for node in nodes:
        if isinstance(node, ast.Call) and isinstance(node.func, ast.Name | ast.Attribute):
            name = node.func.id if isinstance(node.func, ast.Name) else node.func.attr
            kept |= {id(each) for each in node.args} if name in KEEPS else set()
    return all(id(node) in kept for node in nodes if isinstance(node, ast.Name) and node.id == "self")


def run_until(owner: ast.ClassDef, nodes: list[ast.AST]) -> list[ast.AST] | None:
    """Return some nodes of the constructor with those of the methods that it may call; None where one is unknown."""
    methods = {each.name: each for each in owner.body if isinstance(each, FunctionNode)}
    found, waiting, seen = list[ast.AST](), [nodes], set[str]()
    while waiting:
        inside = waiting.pop()
        found += inside
        handed = {id(each) for node in inside for each in callbacks(node)}
        for node in inside:
            if is_of_self(node) and node.attr in methods and id(node) not in handed and node.attr not in seen:
                seen.add(node.attr)
                waiting.append(nodes_of(methods[node.attr]))
        calls = (node.func for node in inside if isinstance(node, ast.Call))
        if any(is_of_self(each) and each.attr not in {*methods, *members_of_nodes()} for each in calls):
            return None
    return found


def callbacks(node: ast.AST) -> list[ast.expr]:
    """Return what a call hands to an executor."""
    if isinstance(node, ast.Call) and is_of_self(node.func) and node.func.attr in REGISTERS:
        return [*node.args, *(each.value for each in node.keywords)]
    return []


def values_before(body: list[ast.stmt], run: list[ast.AST]) -> dict[str, ast.expr]:
    """Return what members are given before a loop that nothing else until then sets, reads or hands on."""
    named = [node.attr for node in run if isinstance(node, ast.Attribute)]
    plain = (each for each in body if isinstance(each, ast.Assign) and len(each.targets) == 1)
    given = [(each.targets[0], each.value) for each in plain]
    return {target.attr: value for target, value in given if is_of_self(target) and named.count(target.attr) == 1}


def truth(test: ast.expr, values: dict[str, ast.expr]) -> bool | None:
    """Return what a test says of members with known values; None where that is unknown, or nothing is asked of them."""
    match test:
        case ast.UnaryOp(op=ast.Not(), operand=operand):
            inside = truth(operand, values)
            return None if inside is None else not inside
        case ast.BoolOp(op=ast.And(), values=parts):
            found = [truth(each, values) for each in parts if not is_going(each)]
            return True if found and all(found) else None
        case ast.BoolOp(op=ast.Or(), values=parts):
            return True if any(truth(each, values) for each in parts) else None
        case ast.Compare(left=left, ops=[asked], comparators=[right]):
            known = value_of(left, values)
            return answer(known[1], asked, right) if known is not None else None
    known = value_of(test, values)
    return bool(known[1]) if known is not None else None


def value_of(node: ast.expr, values: dict[str, ast.expr]) -> Held | None:
    """Return the value of a member, or its length, where that is a literal; of an empty list only its truth counts."""
    match node:
        case ast.Call(func=ast.Name(id="len"), args=[ast.Attribute() as inner]) if is_of_self(inner):
            return (int, 0) if is_empty(values.get(inner.attr)) else None
    given = values.get(node.attr) if is_of_self(node) else None
    return (str, "") if is_empty(given) else constant_of(given)


def is_empty(node: ast.expr | None) -> bool:
    match node:
        case ast.List(elts=[]) | ast.Dict(keys=[]) | ast.Call(func=ast.Name(id="list" | "dict" | "set"), args=[]):
            return not (isinstance(node, ast.Call) and node.keywords)
    return False

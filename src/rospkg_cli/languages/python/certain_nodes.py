"""Code of a Python file that runs for certain when it is imported, or when one of its functions is called."""

from __future__ import annotations

import ast
from collections.abc import Collection, Iterable, Iterator, Sequence

from .attributes import is_of_self
from .constant_truth import constant_truth
from .evaluation_order import in_order
from .file import PythonFile
from .nodes import children_of, nodes_of, nodes_of_kind
from .started_calls import STARTERS

LEAVING = STARTERS | {"exit", "_exit", "fail", "skip"}
"""Calls behind which nothing may run: they don't return before the program ends, or at all."""
ENDED = "is_shutdown"
"""What a loop asks that goes on for as long as ROS runs: `while not context.is_shutdown()`."""

Definition = ast.FunctionDef | ast.AsyncFunctionDef
APART = Definition | ast.Lambda | ast.ExceptHandler
"""What does not run where it stands."""


def certain_nodes(file: PythonFile, entries: Collection[str], *, is_program: bool = False) -> frozenset[int]:
    """Return the identity of each node that runs whatever happens.

    Some functions are called as entries. A file that is a program runs what is under `if __name__ == '__main__'`.
    Functions of the file, classes, and methods of `self` are followed into, where they are called for certain.
    """
    functions = {each.name: each for each in file.tree.body if isinstance(each, ast.FunctionDef)}
    classes = {each.name: each for each in file.tree.body if isinstance(each, ast.ClassDef)}
    waiting: list[tuple[list[ast.stmt], dict[str, ast.FunctionDef]]] = [(file.tree.body, {})]
    waiting += [(functions[name].body, {}) for name in entries if name in functions]
    waiting += [
        (each.body, {}) for each in file.tree.body if is_program and isinstance(each, ast.If) and is_guard(each)
    ]
    found: set[int] = set()
    leaving = LEAVING | {each.name for each in endless(file.tree)}
    for body, methods in waiting:
        for node in straight(body, leaving):
            if id(node) in found:
                continue
            found.add(id(node))
            match node:
                case ast.Call(func=ast.Name(id=name)) if name in functions:
                    waiting.append((functions[name].body, {}))
                case ast.Call(func=ast.Name(id=name)) if name in classes:
                    own = {each.name: each for each in classes[name].body if isinstance(each, ast.FunctionDef)}
                    waiting += [(own["__init__"].body, own)] if "__init__" in own else []
                case ast.Call(func=ast.Attribute(value=ast.Name(id="self"), attr=name)) if name in methods:
                    waiting.append((methods[name].body, methods))
    return frozenset(found)


def is_guard(node: ast.If) -> bool:
    """Return whether this is `if __name__ == '__main__'`."""
    return any(isinstance(each, ast.Name) and each.id == "__name__" for each in nodes_of(node.test))


def endless(tree: ast.Module) -> Iterator[ast.FunctionDef | ast.ClassDef]:
    """Yield the functions and methods with a loop that lasts, and the classes whose objects begin with one."""
    lasting = [each for each in nodes_of_kind(tree, ast.FunctionDef) if any(map(is_endless, loops_in(each)))]
    yield from lasting
    for owner in nodes_of_kind(tree, ast.ClassDef):
        own = {each.name for each in owner.body if each in lasting}
        starts = [each for each in owner.body if isinstance(each, ast.FunctionDef) and each.name == "__init__"]
        calls = (call.func for each in starts for call in nodes_of_kind(each, ast.Call))
        if "__init__" in own or any(is_of_self(each) and each.attr in own for each in calls):
            yield owner


def loops_in(function: ast.FunctionDef) -> list[ast.While]:
    return nodes_of_kind(function, ast.While)


def is_endless(loop: ast.While) -> bool:
    """Return whether a loop may last until the program is stopped: `while True`, `while rclpy.ok()`."""
    return lasts(loop.test)


def lasts(test: ast.expr) -> bool:
    """Return whether a condition holds for good, or for as long as a call says; one that waits for a server ends."""
    match test:
        case ast.Constant(value=value):
            return bool(value)
        case ast.Call(func=ast.Attribute(attr=name) | ast.Name(id=name)):
            return not name.startswith("wait")
        case ast.UnaryOp(op=ast.Not(), operand=ast.Call(func=ast.Attribute(attr=name) | ast.Name(id=name))):
            return name == ENDED
        case ast.BoolOp(op=ast.And(), values=values):
            is_waiting = any("wait" in ast.unparse(each) for each in values)
            return not is_waiting and any(isinstance(each, ast.Call) and lasts(each) for each in values)
    return False


def straight(body: Iterable[ast.stmt], leaving: Collection[str]) -> Iterator[ast.AST]:
    """Yield the nodes of statements that run one after the other, up to the first that may leave them."""
    waiting: list[ast.AST | None] = [*until_left(body, leaving)]
    while waiting:  # without recursion, as every expression is looked through
        node = waiting.pop()
        if node is not None:
            yield node
            waiting += evaluated(node, leaving)


def until_left(body: Iterable[ast.stmt], leaving: Collection[str]) -> Iterator[ast.AST]:
    for statement in body:
        if may_leave(statement, leaving):
            yield from before_leaving(statement, leaving)
            return
        yield statement


def before_leaving(node: ast.AST, leaving: Collection[str]) -> Iterator[ast.AST]:
    """Yield the parts of a statement that run up to the call that may not return, with this: values before targets."""
    while (parts := in_order(node)) and (at := first_leaving(parts, leaving)) is not None:
        yield from parts[:at]
        node = parts[at]
    yield node


def first_leaving(parts: Sequence[ast.AST], leaving: Collection[str]) -> int | None:
    return next((number for number, each in enumerate(parts) if may_leave(each, leaving)), None)


def evaluated(node: ast.AST, leaving: Collection[str]) -> Sequence[ast.AST | None]:
    """Return the parts of a node that run wherever it does."""
    match node:
        case ast.With(items=items, body=body):
            return [*items, *until_left(body, leaving)]
        case ast.Try(body=body):
            return [*until_left(body, leaving)]
        case ast.ClassDef(body=body, decorator_list=decorators, bases=bases):
            return [*decorators, *bases, *until_left(body, leaving)]
        case ast.FunctionDef(args=arguments) | ast.AsyncFunctionDef(args=arguments):
            return [*node.decorator_list, *arguments.defaults, *arguments.kw_defaults]
        case ast.If(test=first, body=body, orelse=other) if (always := constant_truth(first, {})) is not None:
            return [first, *until_left(body if always else other, leaving)]
        case ast.If(test=first) | ast.While(test=first) | ast.IfExp(test=first) | ast.For(iter=first):
            return [first]
        case ast.Match(subject=first) | ast.BoolOp(values=[first, *_]):
            return [first]
        case ast.ListComp() | ast.SetComp() | ast.DictComp() | ast.GeneratorExp():
            return [node.generators[0].iter]
        case ast.Lambda() | ast.Assert():
            return []
    return children_of(node)


def may_leave(statement: ast.AST, leaving: Collection[str]) -> bool:
    """Return whether the next statement may not be reached."""
    waiting: list[ast.AST] = [statement]
    while waiting:
        node = waiting.pop()
        match node:
            case ast.Return() | ast.Raise() | ast.Break() | ast.Continue() | ast.Yield() | ast.Await():
                return True
            case ast.Call(func=ast.Attribute(attr=name) | ast.Name(id=name)) if name in leaving:
                return True
            case ast.While() if is_endless(node):
                return True
        waiting += [] if isinstance(node, APART) else children_of(node)
    return False

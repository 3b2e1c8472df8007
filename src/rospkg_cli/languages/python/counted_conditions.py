"""The nodes of a scope, each with the number of conditions that must hold before it runs."""

from __future__ import annotations

import ast
from collections.abc import Iterator, Mapping, Sequence

from .certain_nodes import is_guard, lasts
from .constant_truth import constant_truth, leaves
from .nodes import FunctionNode, children_of

Counted = tuple[ast.AST, int]
GOING = frozenset({"ok", "not_shutdown"})
"""What holds for as long as a program runs: `if rclpy.ok():` is no condition."""


def counted(body: Sequence[ast.stmt], names: Mapping[str, bool], *, is_program: bool = False) -> Iterator[Counted]:
    """Yield the nodes of a scope that may run, each before its parts, without the bodies of functions in it.

    Branches, handlers and real tests of loops count one each; all guards that leave a block before a place count one
    together. What a `try` holds, a `with`, a `for` or an endless loop counts none. Of the truth of some `names` it is
    known. Only a program comes to what is under `if __name__ == '__main__'`.
    """
    waiting = in_block(body, 0, names)[::-1]
    while waiting:
        node, conditions = waiting.pop()
        yield node, conditions
        if isinstance(node, ast.If) and is_guard(node):
            waiting += in_block(node.body if is_program else node.orelse, conditions, names)[::-1]
        else:
            waiting += parts_of(node, conditions, names)[::-1]


def in_block(block: Sequence[ast.stmt], conditions: int, names: Mapping[str, bool]) -> list[Counted]:
    """Return the statements of a block up to the one behind which nothing runs."""
    found: list[Counted] = []
    guard = 0
    for each in block:
        found.append((each, conditions + guard))
        if leaves(each):
            break
        guard = guard or int(may_leave(each, names))
    return found


def parts_of(node: ast.AST, count: int, names: Mapping[str, bool]) -> list[Counted]:
    """Return the parts of a node with their conditions."""
    match node:
        case ast.If(test=test, body=body, orelse=other):
            always = True if is_going(test) else constant_truth(test, names)
            more = int(always is None) + int(is_over(test))
            branches = (body, always is not False), (other, always is not True)
            inner = [each for part, runs in branches if runs for each in in_block(part, count + more, names)]
            return [(test, count), *inner]
        case ast.While(test=test, body=body, orelse=other):
            more, runs = int(not lasts(test)), constant_truth(test, names) is not False
            loop = in_block(body, count + more, names) if runs else []
            return [(test, count), *loop, *in_block(other, count, names)]
        case ast.For() | ast.AsyncFor():
            loop = in_block(node.body, count, names) if not is_empty(node.iter) else []
            return [(node.iter, count), (node.target, count), *loop, *in_block(node.orelse, count, names)]
        case ast.Try(handlers=handlers):
            tried, last = in_block([*node.body, *node.orelse], count, names), in_block(node.finalbody, count, names)
            return [*tried, *((each, count + 1) for each in handlers), *last]
        case ast.ExceptHandler(body=body) | ast.ClassDef(body=body):
            return in_block(body, count, names)
        case ast.With() | ast.AsyncWith():
            return [*((each, count) for each in node.items), *in_block(node.body, count, names)]
        case ast.match_case():
            return in_block(node.body, count, names)
    return [(each, count + more) for each, more in parts_of_others(node, names)]


def parts_of_others(node: ast.AST, names: Mapping[str, bool]) -> list[Counted]:
    """Return the parts of what holds no blocks, with the conditions that each has of its own."""
    match node:
        case ast.FunctionDef(args=arguments) | ast.AsyncFunctionDef(args=arguments):
            parts = [*node.decorator_list, *arguments.defaults, *arguments.kw_defaults]
            return [(each, 0) for each in parts if each is not None]
        case ast.Match(subject=subject, cases=cases):
            return [(subject, 0), *((each, 1) for each in cases)]
        case ast.IfExp():
            always = constant_truth(node.test, names)
            inner = (node.body, always is not False), (node.orelse, always is not True)
            return [(node.test, 0), *((each, int(always is None)) for each, runs in inner if runs)]
        case ast.BoolOp(op=operator, values=[first, *others]):
            is_settled = constant_truth(first, names) is isinstance(operator, ast.Or)
            return [(first, 0), *((each, 1) for each in others if not is_settled)]
        case ast.ListComp() | ast.SetComp() | ast.GeneratorExp() | ast.DictComp():
            more = int(any(each.ifs for each in node.generators))
            first = node.generators[0].iter
            return [(first, 0), *((each, more) for each in children_of(node))]
        case ast.AnnAssign():
            return [(each, 0) for each in (node.target, node.value) if each is not None]
        case ast.Assert():
            return [(node.test, 0), *([(node.msg, 1)] if node.msg is not None else [])]
    return [(each, 0) for each in children_of(node)]


def is_empty(each: ast.expr) -> bool:
    """Return whether a loop goes over nothing: `for each in []`."""
    match each:
        case ast.List(elts=[]) | ast.Tuple(elts=[]) | ast.Dict(keys=[]):
            return True
        case ast.Call(func=ast.Name(id="range"), args=[ast.Constant(value=0)]):
            return True
    return False


def is_going(test: ast.expr) -> bool:
    """Return whether a test asks whether the program still runs."""
    return isinstance(test, ast.Call) and isinstance(test.func, ast.Attribute) and test.func.attr in GOING


def is_over(test: ast.expr) -> bool:
    """Return whether a test asks whether the program was stopped: `if not rclpy.ok():`."""
    return isinstance(test, ast.UnaryOp) and isinstance(test.op, ast.Not) and is_going(test.operand)


def may_leave(statement: ast.AST, names: Mapping[str, bool], *, in_loop: bool = False) -> bool:
    """Return whether a statement leaves its block under a condition; what a handler does is no ordinary way."""
    match statement:
        case ast.If(test=test) if constant_truth(test, names) is not None or is_guard(statement):
            return False
        case ast.If(test=test) if is_over(test):
            return False
        case ast.Break() | ast.Continue():
            return not in_loop
        case ast.Return() | ast.Raise():
            return True
        case ast.Expr():
            return isinstance(statement, ast.stmt) and leaves(statement)
    is_apart = isinstance(statement, FunctionNode | ast.ClassDef | ast.ExceptHandler | ast.expr)
    in_loop = in_loop or isinstance(statement, ast.For | ast.AsyncFor | ast.While)
    return not is_apart and any(may_leave(each, names, in_loop=in_loop) for each in children_of(statement))

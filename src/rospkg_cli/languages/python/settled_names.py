"""What comparisons of names always say that only ever hold known constants: `step = 0`, never counted on."""

from __future__ import annotations

import ast
import operator
from collections.abc import Callable, Collection, Iterable, Iterator, Mapping
from typing import Any

from .file import PythonFile
from .nodes import COMPARISONS, FunctionNode, nodes_of, nodes_of_kind

Constant = str | bytes | int | float | complex | bool | None
Held = tuple[type, Constant]
Values = Mapping[str, frozenset[Held]]
"""All that each name may hold, with its type, as `True == 1`; of a member the name begins with `self.`."""

OPERATORS: Mapping[type[ast.cmpop], Callable[[Any, Any], Any]] = {
    **COMPARISONS, ast.Is: operator.is_, ast.IsNot: operator.is_not,
}  # fmt: skip

OF_TEXT: Mapping[str, Callable[[str], str]] = {"lower": str.lower, "upper": str.upper, "strip": str.strip}


def truths(tests: Iterable[ast.expr], values: Values) -> dict[str, bool]:
    """Return what the names in some tests, and their comparisons with constants, always are, by their text."""
    found: dict[str, bool] = {}
    for test in tests:
        for node in nodes_of(test) if values else ():
            held = values.get(name_of(node), frozenset())
            if held and len(each := {bool(value) for _, value in held}) == 1:
                found[name_of(node)] = each.pop()
            match node:
                case ast.Compare(left=left, ops=[asked], comparators=[right]) if of := held_by(left, values):
                    every = {answer(value, asked, right) for _, value in of}
                    if len(every) == 1 and (always := every.pop()) is not None:
                        found[ast.unparse(node)] = always
    return found


def held_by(node: ast.expr, values: Values) -> frozenset[Held]:
    """Return all that a name may hold, or a call on the text in it: `answer.lower()`; nothing where that is unknown."""
    match node:
        case ast.Call(func=ast.Attribute(value=inner, attr=method), args=[], keywords=[]) if method in OF_TEXT:
            held = values.get(name_of(inner), frozenset())
            texts = [value for _, value in held if isinstance(value, str)]
            return frozenset((str, OF_TEXT[method](each)) for each in texts) if len(texts) == len(held) else frozenset()
    return values.get(name_of(node), frozenset())


def answer(value: Constant, asked: ast.cmpop, right: ast.expr) -> bool | None:
    """Return what a comparison says; None where that is unknown, or raises."""
    known = constant_of(right)
    if known is None or type(asked) not in OPERATORS:
        return None
    try:
        return bool(OPERATORS[type(asked)](value, known[1]))
    except TypeError:
        return None


def constant_of(node: ast.expr | None) -> Held | None:
    """Return a literal value with its type: `-1`, too."""
    match node:
        case ast.Constant(value=value) if value is not Ellipsis:
            return type(value), value
        case ast.UnaryOp(op=ast.USub(), operand=ast.Constant(value=int() | float() as value)):
            return type(value), -value
    return None


def name_of(node: ast.AST) -> str:
    match node:
        case ast.Name(id=name):
            return name
        case ast.Attribute(value=ast.Name(id="self"), attr=name):
            return f"self.{name}"
    return ""


def settled_in(scope: FunctionNode | ast.Module, file: PythonFile, idle: Collection[ast.stmt] = frozenset()) -> Values:
    """Return the names that a scope binds to literal values alone; nothing else of it, nor of functions in it, does.

    What is in idle statements never runs.
    """
    found: dict[str, set[Held]] = {}
    unread = {id(node) for each in idle for node in nodes_of(each)}
    plain = {*unread}
    pairs = [(each.targets, each.value) for each in nodes_of_kind(scope, ast.Assign)]
    pairs += [([each.target], each.value) for each in nodes_of_kind(scope, ast.AnnAssign) if each.value is not None]
    for targets, given in pairs:
        value = constant_of(given) if id(given) not in unread else None
        for target in targets:
            if isinstance(target, ast.Name) and value is not None:
                plain.add(id(target))
                found.setdefault(target.id, set()).add(value)
    if not found:
        return {}
    others = {*bound_otherwise(scope, plain)}
    others |= {
        name for node in nodes_of(file.tree) if isinstance(node, ast.Global | ast.Nonlocal) for name in node.names
    }
    return {name: frozenset(held) for name, held in found.items() if name not in others}


def bound_otherwise(scope: ast.AST, plain: set[int]) -> Iterator[str]:
    """Yield what is bound or removed in a scope but by the plain assignments."""
    for node in nodes_of(scope):
        match node:
            case ast.Name(id=name, ctx=ast.Store() | ast.Del()) if id(node) not in plain:
                yield name
            case ast.arg(arg=name) | ast.ExceptHandler(name=str(name)) | ast.MatchAs(name=str(name)):
                yield name
            case ast.MatchStar(name=str(name)) | ast.MatchMapping(rest=str(name)):
                yield name
            case ast.alias():
                yield (node.asname or node.name).partition(".")[0]
            case ast.FunctionDef(name=name) | ast.AsyncFunctionDef(name=name) | ast.ClassDef(name=name):
                yield name

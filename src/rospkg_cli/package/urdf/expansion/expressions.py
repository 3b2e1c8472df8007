"""Evaluate `${…}` as xacro does, without Python's own eval: names, numbers, texts, comparisons and a few functions."""

from __future__ import annotations

import ast
import math
import operator
from collections.abc import Callable, Mapping
from typing import Any

from ....languages.python.nodes import COMPARISONS, nodes_of
from .values import Value, XacroUnknown

MATH = frozenset(name for name in dir(math) if not name.startswith("_"))
GLOBAL = MATH | frozenset(
    "list dict map len str float int bool True False min max round sorted range load_yaml abs_filename dotify "
    "xacro math python None".split()
)
"""The names that every expression knows. (xacro/__init__.py: create_global_symbols)"""

MAX_TEXT = 2_000
MAX_POWER = 64
OPERATORS: Mapping[type, Callable[[Any, Any], Any]] = {
    ast.Add: operator.add,
    ast.Sub: operator.sub,
    ast.Mult: operator.mul,
    ast.Div: operator.truediv,
    ast.FloorDiv: operator.floordiv,
    ast.Mod: operator.mod,
    ast.Pow: operator.pow,
    **COMPARISONS,
}
FUNCTIONS: Mapping[str, Callable[..., Any]] = {
    **{name: getattr(math, name) for name in MATH if callable(getattr(math, name)) and "fact" not in name},
    "abs": abs, "float": float, "int": int, "len": len, "max": max, "min": min, "round": round, "str": str,
}  # fmt: skip


class NoValueError(Exception):
    """The expression needs what is not known."""


def parsed(expression: str) -> ast.expr | None:
    """Return the tree of an expression; None where it has none."""
    if len(expression) > MAX_TEXT:
        return None
    try:
        return ast.parse(expression.strip(), mode="eval").body
    except (SyntaxError, ValueError, RecursionError, MemoryError):
        return None


def free_names(tree: ast.expr) -> list[str]:
    """Return the names that an expression reads and does not bind itself, in order."""
    nodes = nodes_of(tree)
    bound = {node.id for node in nodes if isinstance(node, ast.Name) and not isinstance(node.ctx, ast.Load)}
    bound |= {node.arg for node in nodes if isinstance(node, ast.arg)}
    return [node.id for node in nodes if isinstance(node, ast.Name) and node.id not in bound]


def evaluate(tree: ast.expr, names: Mapping[str, Value]) -> Value:
    """Return the value of an expression; raises NoValueError where it depends on what is not known, or fails."""
    try:
        found = value_of(tree, names)
    except (TypeError, ValueError, ArithmeticError, RecursionError):
        raise NoValueError from None
    if not isinstance(found, str | int | float | bool) or (isinstance(found, str) and len(found) > MAX_TEXT):
        raise NoValueError
    return found


def value_of(node: ast.expr, names: Mapping[str, Value]) -> Any:
    match node:
        case ast.Constant(value=value):
            return value
        case ast.Name(id=name):
            return known(name, names)
        case ast.Attribute(value=ast.Name(id="math"), attr="pi" | "e" | "tau" as name):
            return getattr(math, name)
        case ast.UnaryOp(op=ast.Not(), operand=inner):
            return not value_of(inner, names)
        case ast.UnaryOp(op=ast.USub(), operand=inner):
            return -value_of(inner, names)
        case ast.BoolOp(op=how, values=values):
            return logical(isinstance(how, ast.Or), values, names)
        case ast.BinOp(left=left, op=how, right=right):
            return combined(type(how), value_of(left, names), value_of(right, names))
        case ast.Compare(left=left, ops=[how], comparators=[right]):
            return combined(type(how), value_of(left, names), value_of(right, names))
        case ast.IfExp(test=test, body=body, orelse=other):
            return value_of(body if value_of(test, names) else other, names)
        case ast.Call(func=ast.Name(id=name), args=arguments, keywords=[]):
            return called(name, [value_of(each, names) for each in arguments])
        case ast.Call(func=ast.Attribute(value=ast.Name(id="math"), attr=name), args=arguments, keywords=[]):
            return called(name, [value_of(each, names) for each in arguments])
    raise NoValueError


def known(name: str, names: Mapping[str, Value]) -> Any:
    if name in names:
        if isinstance(names[name], XacroUnknown):
            raise NoValueError
        return names[name]
    if name in ("pi", "e", "tau", "inf", "nan"):
        return getattr(math, name)
    raise NoValueError


def logical(is_or: bool, values: list[ast.expr], names: Mapping[str, Value]) -> Any:
    """Return the value of `a and b`: one that decides is enough, though others are unknown."""
    found: Any = not is_or
    for each in values:
        found = value_of(each, names)
        if bool(found) is is_or:
            return found
    return found


def combined(how: type, left: Any, right: Any) -> Any:
    is_huge = how is ast.Pow and not (abs(left) <= MAX_TEXT and abs(right) <= MAX_POWER)
    if how not in OPERATORS or is_huge or (how is ast.Mult and isinstance(left, str) != isinstance(right, str)):
        raise NoValueError
    return OPERATORS[how](left, right)


def called(name: str, arguments: list[Any]) -> Any:
    if name not in FUNCTIONS or any(isinstance(each, int) and abs(each) > 10**9 for each in arguments):
        raise NoValueError
    return FUNCTIONS[name](*arguments)

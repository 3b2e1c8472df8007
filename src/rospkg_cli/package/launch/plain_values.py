"""What a small Python expression is: constants, comparisons, and what is done with texts, as far as names are known."""

from __future__ import annotations

import ast
import operator
from collections.abc import Callable, Iterable
from typing import Any

from ...languages.python.nodes import COMPARISONS

TEXT_METHODS = frozenset({"lower", "upper", "strip", "casefold", "startswith", "endswith", "capitalize", "title"})
FUNCTIONS: dict[str, Callable[[Any], object]] = {"str": str, "bool": bool, "len": len}
SIGNS: dict[type[ast.cmpop], Callable[[Any, Any], bool]] = {
    **COMPARISONS, ast.Is: operator.eq, ast.IsNot: operator.ne,
    ast.In: lambda left, right: left in right,
    ast.NotIn: lambda left, right: left not in right,
}  # fmt: skip
WORDS = {"true": True, "false": False}
"""What launch arguments are to an expression that they are put into without quotes."""
Known = Callable[[ast.expr], object]


class NotKnownError(Exception):
    """The value depends on what is not known."""


def unknown(_: ast.expr) -> object:
    raise NotKnownError


def plain_value(node: ast.expr, known: Known = unknown) -> object:
    """Return the value of an expression; `known` gives that of a name, a call, an attribute or an item.

    Raises NotKnownError.
    """
    match node:
        case ast.Constant(value=value):
            return value
        case ast.List(elts=items) | ast.Tuple(elts=items) | ast.Set(elts=items):
            return [plain_value(each, known) for each in items]
        case ast.UnaryOp(op=ast.Not(), operand=operand):
            return not plain_value(operand, known)
        case ast.BoolOp(op=joint, values=values):
            return joined(values, known, decides=isinstance(joint, ast.Or))
        case ast.Compare(left=left, ops=signs, comparators=others):
            return compared([left, *others], signs, known)
        case ast.Call(func=ast.Attribute(value=of, attr=name), args=args, keywords=[]) if name in TEXT_METHODS:
            text = plain_value(of, known)
            if isinstance(text, str):
                return getattr(text, name)(*(plain_value(each, known) for each in args))
        case ast.Call(func=ast.Name(id=name), args=[only], keywords=[]) if name in FUNCTIONS:
            return FUNCTIONS[name](plain_value(only, known))
        case ast.Name(id=name) if name.lower() in WORDS:
            return WORDS[name.lower()]
        case ast.Name() | ast.Call() | ast.Attribute() | ast.Subscript():
            return known(node)
    raise NotKnownError


def joined(values: Iterable[ast.expr], known: Known, *, decides: bool) -> bool:
    """Return what `and` or `or` makes of values, some of which may be unknown where another one decides."""
    is_known = True
    for each in values:
        try:
            if bool(plain_value(each, known)) is decides:
                return decides
        except NotKnownError:
            is_known = False
    if not is_known:
        raise NotKnownError
    return not decides


def compared(operands: list[ast.expr], signs: list[ast.cmpop], known: Known) -> bool:
    values = [plain_value(each, known) for each in operands]
    try:
        return all(SIGNS[type(sign)](*values[at : at + 2]) for at, sign in enumerate(signs))
    except TypeError:
        raise NotKnownError from None


def truth_of_text(expression: str) -> bool | None:
    """Return the truth of an expression in a text; None where it is not known."""
    try:
        return bool(plain_value(ast.parse(expression.strip(), mode="eval").body))
    except (NotKnownError, SyntaxError, ValueError, TypeError, RecursionError, MemoryError):
        return None

"""Calls, subscripts and attributes of literals, which raise: two items of a list without a comma between them.

They are what CPython's compiler warns of with "perhaps you missed a comma?".
"""

from __future__ import annotations

import ast
from collections.abc import Iterator
from io import StringIO

from ...light_dataclasses import dataclass
from ...source import Span
from .file import PythonFile
from .nodes import nodes_of

KINDS: dict[type[ast.expr], str] = {
    ast.Tuple: "tuple", ast.List: "list", ast.ListComp: "list", ast.Dict: "dict", ast.DictComp: "dict",
    ast.Set: "set", ast.SetComp: "set", ast.GeneratorExp: "generator", ast.JoinedStr: "str",
}  # fmt: skip
"""What Python calls the value of each kind of literal."""

SEQUENCES = ("tuple", "list", "str")


@dataclass(frozen=True, slots=True)
class LostComma:
    """Where a comma belongs, and what Python raises without it."""

    span: Span
    """From the start of the first item to the end of the second."""
    position: int
    """Behind the first item."""
    error: str
    """What the exception says."""
    exception: str = "TypeError"
    instead: int = 0
    """The length of what stands there in its place."""


def lost_commas(file: PythonFile) -> Iterator[LostComma]:
    """Yield the places where a literal is called, subscripted by no index, or has an attribute that no string has."""
    for node in nodes_of(file.tree):
        match node:
            case ast.Call(func=first) if kind := kind_of(first):
                yield LostComma(file.span(node), file.span(first).end, f"'{kind}' object is not callable")
            case ast.Subscript(value=first, slice=index) if (kind := kind_of(first)) in SEQUENCES and (
                other := kind_of(index)
            ):
                what = "string" if kind == "str" else kind
                error = f"{what} indices must be integers or slices, not {other}"
                yield LostComma(file.span(node), file.span(first).end, error)
            case ast.Attribute(value=ast.Constant(value=str()) as first, attr=name) if not hasattr("", name):
                error = f"'str' object has no attribute '{name}'"
                if file.source.text.startswith(".", file.span(first).end):
                    yield LostComma(file.span(node), file.span(first).end, error, "AttributeError", len("."))


def kind_of(node: ast.expr) -> str:
    """Return the type of a literal's value; "" for other expressions, and for numbers."""
    if isinstance(node, ast.Constant):
        return "str" if isinstance(node.value, str) else ""
    return KINDS.get(type(node), "")


def joined_strings(text: str) -> list[str]:
    """Return the values of the plain strings that an expression joins by writing them side by side, else nothing."""
    import tokenize  # it takes a start some milliseconds, and few files are in doubt

    blank = (tokenize.COMMENT, tokenize.ENDMARKER, tokenize.NEWLINE, tokenize.NL)
    try:
        every = tokenize.generate_tokens(StringIO(f"({text}\n)").readline)
        tokens = [each for each in every if each.type not in blank]
        values = [ast.literal_eval(each.string) for each in tokens[1:-1]] if len(tokens) > len("(a)") else []
    except (tokenize.TokenError, SyntaxError, ValueError):
        return []
    return values if all(isinstance(each, str) for each in values) else []

"""The folders in which Python looks for files, and the parts of paths to compare them by."""

from __future__ import annotations

import ast
from collections.abc import Iterator, Mapping

from ...languages.python.nodes import last_name, nodes_of

Names = Mapping[str, ast.expr]
"""What is bound to each name that is bound once."""
MAX_STEPS = 12
"""Names and paths inside of one another, at most."""
WRAPPING = frozenset({"str", "Path", "abspath", "realpath", "expanduser"})
"""What a path is given to and stays the same path."""
GLOBS = frozenset({"glob", "iglob", "rglob"})
LISTS = frozenset({"listdir", "iterdir", "scandir"})


def searched_in(searched: ast.AST, names: Names) -> Iterator[tuple[list[str], str]]:
    """Yield the parts of each folder that is searched, with the pattern of the names that are looked for."""
    for call in nodes_of(searched):
        if not isinstance(call, ast.Call) or last_name(call.func) not in GLOBS | LISTS:
            continue
        is_list = last_name(call.func) in LISTS
        owner = call.func.value if isinstance(call.func, ast.Attribute) else None
        is_method = owner is not None and last_name(owner) not in ("glob", "os")
        parts = parts_of(owner, names) if owner is not None and is_method else []
        parts += [part for each in call.args[:1] for part in parts_of(each, names)]
        parts += ["*"] if is_list else []
        if parts:
            yield parts[:-1], parts[-1]


def parts_of(path: ast.expr, names: Names, steps: int = MAX_STEPS) -> list[str]:
    """Return the parts of a path: the words of its texts, and the code of what else it is joined of."""
    if steps == 0:
        return [ast.unparse(path)]
    inner: list[ast.expr] = []
    match path:
        case ast.Constant(value=str(text)):
            return [each for each in text.split("/") if each]
        case ast.Name(id=name) if name in names and is_path(names[name]):
            inner = [names[name]]
        case ast.BinOp(left=left, op=ast.Div() | ast.Add(), right=right):
            inner = [left, right]
        case ast.JoinedStr(values=values):
            inner = [each.value if isinstance(each, ast.FormattedValue) else each for each in values]
        case ast.Call(func=function, args=args) if last_name(function) in (*WRAPPING, "join", "joinpath"):
            is_method = isinstance(function, ast.Attribute) and last_name(function) == "joinpath"
            inner = [function.value, *args] if is_method and isinstance(function, ast.Attribute) else args
    return [part for each in inner for part in parts_of(each, names, steps - 1)] or [ast.unparse(path)]


def is_path(value: ast.expr) -> bool:
    """Return whether a value is a path that is put together."""
    if isinstance(value, ast.Call):
        return last_name(value.func) in (*WRAPPING, "join", "joinpath")
    return isinstance(value, ast.BinOp | ast.JoinedStr) or (
        isinstance(value, ast.Constant) and isinstance(value.value, str)
    )

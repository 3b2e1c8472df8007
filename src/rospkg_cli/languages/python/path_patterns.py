"""Paths that Python code puts together, with a mark for each part that only a run knows: `…/worlds/modified_…`."""

from __future__ import annotations

import ast
from collections.abc import Callable, Iterator

from ...lazy_regex import regex
from .file import PythonFile
from .nodes import last_name, nodes_of_kind

JOINERS = frozenset({"join", "joinpath", "Path", "PurePath", "str", "expanduser", "abspath", "realpath", "resolve"})
PARAMETERS = frozenset({"get_parameter", "declare_parameter"})
FIELD = regex(r"\{[^{}]*\}")
PERCENT = regex(r"%[-+0-9.]*[sdif]")
MAX_DEPTH, LONGEST = 20, 1000


class PathPatterns:
    """Evaluates the expressions of a file as texts; `unknown` stands for what is not literal in them.

    `base_of` returns the text of a call that returns a known folder, else "". A name and an attribute of `self` are
    followed to what the file gives them, and a ROS parameter to its default, unless it may have any value.
    """

    def __init__(
        self, file: PythonFile, unknown: str, base_of: Callable[[ast.Call, PathPatterns], str], any_value: bool
    ) -> None:
        self.unknown = unknown
        self.base_of = base_of
        self.values: dict[str, list[tuple[int, ast.expr | None]]] = {}
        """What each name gets, by the line; None for what is not evaluated."""
        known = dict(assignments(file))
        names: list[ast.Name | ast.Attribute] = [*nodes_of_kind(file.tree, ast.Name)]
        for name in (*names, *nodes_of_kind(file.tree, ast.Attribute)):
            if isinstance(name.ctx, ast.Store):
                self.values.setdefault(ast.unparse(name), []).append((name.lineno, known.get(name)))
        for argument in nodes_of_kind(file.tree, ast.arg):
            self.values.setdefault(argument.arg, []).append((argument.lineno, None))
        self.defaults = {} if any_value else dict(declared(file))
        self.known: dict[ast.expr, str] = {}

    def text(self, node: ast.expr, depth: int = 0) -> str:
        """Return the text of an expression; the end of a long one."""
        if node not in self.known:
            self.known[node] = self.evaluated(node, depth)[-LONGEST:]
        return self.known[node]

    def evaluated(self, node: ast.expr, depth: int) -> str:
        if depth > MAX_DEPTH:
            return self.unknown
        match node:
            case ast.Constant(value=str() as text):
                return text
            case ast.Name() | ast.Attribute() if (name := ast.unparse(node)) in self.values:
                value = self.bound_before(name, node.lineno)
                return self.text(value, depth + 1) if value is not None else self.unknown
            case ast.BinOp(left=left, op=ast.Add(), right=right):
                return self.text(left, depth + 1) + self.text(right, depth + 1)
            case ast.BinOp(left=left, op=ast.Div(), right=right):
                return self.joined([left, right], depth)
            case ast.BinOp(left=left, op=ast.Mod()):
                return PERCENT.sub(self.unknown, self.text(left, depth + 1))
            case ast.JoinedStr(values=values):
                return "".join(self.text(each, depth + 1) for each in values)
            case ast.FormattedValue(value=value) | ast.Attribute(value=value, attr="value" | "string_value"):
                return self.text(value, depth + 1)
            case ast.Attribute(value=value, attr="parent"):
                return self.text(value, depth + 1).rpartition("/")[0] or self.unknown
            case ast.Call():
                return self.called(node, depth)
        return self.unknown

    def held(self, node: ast.expr) -> ast.expr:
        """Return what a variable holds, where that is known; an expression of another kind as it is."""
        if not isinstance(node, ast.Name) or node.id not in self.values:
            return node
        return self.bound_before(node.id, node.lineno) or node

    def bound_before(self, name: str, line: int) -> ast.expr | None:
        """Return what a name holds on a line, as the lines above say; an attribute may get it below."""
        bound = sorted(self.values[name], key=lambda each: each[0])
        above = [value for at, value in bound if at < line]
        return above[-1] if above else bound[0][1] if "." in name and len(bound) == 1 else None

    def called(self, call: ast.Call, depth: int) -> str:
        """Return the text that a call returns."""
        match call:
            case ast.Call() if base := self.base_of(call, self):
                return base
            case ast.Call(func=ast.Attribute(attr="format", value=value)):
                return FIELD.sub(self.unknown, self.text(value, depth + 1))
            case ast.Call(func=ast.Attribute(attr="get_parameter_value", value=value), args=[]):
                return self.text(value, depth + 1)
            case ast.Call(func=ast.Attribute(attr=name), args=[ast.Constant(value=key), *_]) if name in PARAMETERS:
                default = self.defaults.get(key)
                return self.text(default, depth + 1) if default is not None else self.unknown
            case ast.Call(func=ast.Attribute(attr="joinpath" | "resolve", value=value), args=args):
                return self.joined([value, *args], depth)
            case ast.Call(args=[path]) if last_name(call.func) == "dirname":
                return self.text(path, depth + 1).rpartition("/")[0] or self.unknown
            case ast.Call(args=args) if args and last_name(call.func) in JOINERS:
                return self.joined(args, depth)
        return self.unknown

    def joined(self, parts: list[ast.expr], depth: int) -> str:
        return "/".join(self.text(each, depth + 1).rstrip("/") for each in parts)


def assignments(file: PythonFile) -> Iterator[tuple[ast.AST, ast.expr]]:
    """Yield each target that is assigned one value."""
    for each in nodes_of_kind(file.tree, ast.Assign):
        yield from ((target, each.value) for target in each.targets)
    for one in nodes_of_kind(file.tree, ast.AnnAssign):
        if one.value is not None:
            yield one.target, one.value


def declared(file: PythonFile) -> Iterator[tuple[object, ast.expr]]:
    """Yield the names of parameters with their defaults."""
    for call in nodes_of_kind(file.tree, ast.Call):
        if (
            last_name(call.func) == "declare_parameter"
            and len(call.args) > 1
            and isinstance(call.args[0], ast.Constant)
        ):
            yield call.args[0].value, call.args[1]

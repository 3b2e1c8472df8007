"""Paths that Python code joins from literal parts: `os.path.join(base(), 'a', 'b')`, `base() / 'a'`, f-strings."""

from __future__ import annotations

import ast
from collections import Counter
from collections.abc import Callable, Iterator

from ...light_dataclasses import dataclass
from .bindings import bindings
from .file import PythonFile
from .nodes import children_of, nodes_of

JOINERS = frozenset({"join", "joinpath", "Path", "PurePath", "str"})
WHOLE = (ast.BinOp, ast.JoinedStr, ast.Call)
MAX_DEPTH = 50


@dataclass(frozen=True, slots=True)
class BasedPath:
    """A path below a base that is known by name."""

    base: str
    text: str
    """Behind the base, as it is joined: `/config/a.yaml`."""
    node: ast.expr
    """The whole expression."""


class PathJoiner:
    """Evaluates the expressions of a file that are paths below a base; `base_of` returns what a call is the base of."""

    def __init__(self, file: PythonFile, base_of: Callable[[ast.Call, PathJoiner], str]) -> None:
        self.file = file
        self.base_of = base_of
        every = Counter(node.id for node in nodes_of(file.tree) if isinstance(node, ast.Name) and is_stored(node))
        every.update(node.arg for node in nodes_of(file.tree) if isinstance(node, ast.arg))
        every.update(
            name
            for name, node in bindings(file.tree.body, has_globals="global" in file.source.text)
            if not isinstance(node, ast.Name)
        )
        self.values = {
            node.targets[0].id: node.value
            for node in nodes_of(file.tree)
            if isinstance(node, ast.Assign) and len(node.targets) == 1 and isinstance(node.targets[0], ast.Name)
            if every[node.targets[0].id] == 1
        }
        """What the names hold that are bound only once."""

    def paths(self) -> Iterator[BasedPath]:
        """Yield the paths with something behind their base, each in its longest form."""
        waiting: list[ast.AST] = [self.file.tree]
        while waiting:
            node = waiting.pop()
            if isinstance(node, WHOLE) and (found := self.path(node)) is not None and found[1].strip("/"):
                yield BasedPath(*found, node)
            else:
                waiting += children_of(node)

    def text(self, node: ast.expr, depth: int = 0) -> str | None:
        """Return a text that is a literal, or a name for one."""
        if isinstance(node, ast.Constant):
            return node.value if isinstance(node.value, str) else None
        if isinstance(node, ast.Name) and node.id in self.values and depth < MAX_DEPTH:
            return self.text(self.values[node.id], depth + 1)
        return None

    def path(self, node: ast.expr, depth: int = 0) -> tuple[str, str] | None:
        """Return the base and what is joined to it; None for other expressions, and where a part is unknown."""
        if depth > MAX_DEPTH:
            return None
        match node:
            case ast.Name(id=name) if name in self.values:
                return self.path(self.values[name], depth + 1)
            case ast.BinOp(left=left, op=ast.Div(), right=right):
                return self.joined(left, [right], depth)
            case ast.BinOp(left=left, op=ast.Add(), right=right):
                return self.appended([left, right], depth)
            case ast.JoinedStr(values=values):
                inner = [each.value if isinstance(each, ast.FormattedValue) else each for each in values]
                return self.appended(inner, depth)
            case ast.Call() if base := self.base_of(node, self):
                return base, ""
            case ast.Call(func=ast.Attribute(attr="joinpath", value=value), args=args):
                return self.joined(value, args, depth)
            case ast.Call(func=ast.Attribute(attr=name) | ast.Name(id=name), args=[first, *rest], keywords=[]):
                return self.joined(first, rest, depth) if name in JOINERS else None
        return None

    def joined(self, first: ast.expr, others: list[ast.expr], depth: int) -> tuple[str, str] | None:
        start, parts = self.path(first, depth + 1), [self.text(each) for each in others]
        if start is None or any(part is None or part.startswith("/") for part in parts):
            return None
        return start[0], "/".join([start[1], *[part for part in parts if part]])

    def appended(self, nodes: list[ast.expr], depth: int) -> tuple[str, str] | None:
        start, parts = self.path(nodes[0], depth + 1) if nodes else None, [self.text(each) for each in nodes[1:]]
        if start is None or any(part is None for part in parts):
            return None
        return start[0], start[1] + "".join(part for part in parts if part)


def is_stored(node: ast.Name) -> bool:
    return not isinstance(node.ctx, ast.Load)

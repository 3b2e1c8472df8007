"""Names that a Python file uses and that nothing in it defines or imports."""

from __future__ import annotations

import ast
import builtins
from collections.abc import Iterable, Iterator

from ...light_dataclasses import dataclass
from ...source import Span
from .file import PythonFile, bindings
from .nodes import children_of, nodes_of

GIVEN = frozenset(dir(builtins)) | frozenset(
    "__file__ __name__ __doc__ __package__ __loader__ __spec__ __builtins__ __path__ __cached__ __annotations__".split()
)
CATCHES = frozenset({"NameError", "Exception", "BaseException"})

FunctionNode = ast.FunctionDef | ast.AsyncFunctionDef | ast.Lambda


@dataclass(frozen=True, slots=True)
class UndefinedName:
    """A use of a name that no scope binds."""

    name: str
    span: Span
    known: frozenset[str]
    """The names that are bound there, without builtins."""


def undefined_names(file: PythonFile) -> Iterator[UndefinedName]:
    """Yield uses of names that no scope around them binds; none where a file may have names that it does not show."""
    if file.star_imports or file.has_dynamic_names or any("*" in each.names for each in file.imports):
        return
    top = set(file.definitions)
    if any(isinstance(node, ast.Name) and node.id in ("exec", "eval", "locals") for node in nodes_of(file.tree)):
        return
    for name in NameVisitor(frozenset(top)).in_body(file.tree.body, frozenset(top)):
        yield UndefinedName(name[0].id, file.span(name[0]), name[1])


def is_in_branch(file: PythonFile, span: Span) -> bool:
    """Return whether a place lies in a branch of an `if` that Python may not get to."""
    for node in ast.walk(file.tree):
        bodies: list[ast.stmt] | list[ast.expr] = []
        if isinstance(node, ast.If):
            bodies = [*node.body, *node.orelse]
        elif isinstance(node, ast.IfExp):
            bodies = [node.body, node.orelse]
        if any(file.span(each).start <= span.start and span.end <= file.span(each).end for each in bodies):
            return True
    return False


def is_in_function(file: PythonFile, span: Span) -> bool:
    """Return whether a place lies in a function, which may not be called."""
    spans = (file.span(node) for node in nodes_of(file.tree) if isinstance(node, FunctionNode))
    return any(each.start <= span.start < each.end for each in spans)


Found = tuple[ast.Name, frozenset[str]]


class NameVisitor:
    """Walks scopes with the names that each of them sees."""

    def __init__(self, top: frozenset[str]) -> None:
        self.top = top

    def in_body(self, nodes: Iterable[ast.AST | None], seen: frozenset[str]) -> Iterator[Found]:
        for node in nodes:
            if node is not None:
                yield from self.within(node, seen)

    def within(self, node: ast.AST, seen: frozenset[str]) -> Iterator[Found]:
        match node:
            case ast.Name(ctx=ast.Load()):
                if node.id not in seen and node.id not in GIVEN:
                    yield node, seen
            case ast.FunctionDef() | ast.AsyncFunctionDef() | ast.Lambda():
                yield from self.function(node, seen)
            case ast.ClassDef():
                yield from self.in_body([*node.decorator_list, *node.bases, *node.keywords], seen)
                yield from self.class_body(node, seen)
            case ast.ListComp() | ast.SetComp() | ast.DictComp() | ast.GeneratorExp():
                inner = seen | {name for each in node.generators for name, _ in bindings([each.target])}
                yield from self.in_body(children_of(node), inner)
            case ast.AnnAssign():
                yield from self.in_body([node.target, node.value], seen)
            case ast.Try() if any(map(catches, node.handlers)):
                yield from self.in_body([*node.handlers, *node.finalbody], seen)
            case ast.ExceptHandler(name=str(name)):
                yield from self.in_body([node.type, *node.body], seen | {name})
            case ast.Match():
                yield from self.in_body(children_of(node), seen | set(captured(node)))
            case _:
                yield from self.in_body(children_of(node), seen)

    def function(self, node: FunctionNode, seen: frozenset[str]) -> Iterator[Found]:
        arguments = node.args
        yield from self.in_body([*arguments.defaults, *arguments.kw_defaults], seen)
        every = [*arguments.posonlyargs, *arguments.args, *arguments.kwonlyargs, arguments.vararg, arguments.kwarg]
        own = {each.arg for each in every if each is not None}
        body = [node.body] if isinstance(node, ast.Lambda) else node.body
        if not isinstance(node, ast.Lambda):
            yield from self.in_body(node.decorator_list, seen)
        yield from self.in_body(body, seen | own | bound_in(body))

    def class_body(self, node: ast.ClassDef, seen: frozenset[str]) -> Iterator[Found]:
        """Yield from a class, whose names its own statements see and its methods don't."""
        own = seen | bound_in(node.body) | {"__class__", "__qualname__", "__module__"}
        for each in node.body:
            is_function = isinstance(each, ast.FunctionDef | ast.AsyncFunctionDef)
            yield from self.within(each, seen | {"__class__", "super"} if is_function else own)


def bound_in(body: Iterable[ast.AST]) -> frozenset[str]:
    """Return the names that a scope binds, also by `global` (then some scope of the file does), `except`, `match`."""
    body = list(body)
    names = {name for name, _ in bindings(body)}
    for each in body:
        for node in nodes_of(each):
            if isinstance(node, ast.Global | ast.Nonlocal):
                names |= set(node.names)
            elif isinstance(node, ast.NamedExpr):
                names.add(node.target.id)
            elif isinstance(node, ast.ExceptHandler) and node.name:
                names.add(node.name)
            elif isinstance(node, ast.Match):
                names |= set(captured(node))
    return frozenset(names)


def captured(node: ast.Match) -> Iterator[str]:
    for each in nodes_of(node):
        if isinstance(each, ast.MatchAs | ast.MatchStar) and each.name:
            yield each.name
        elif isinstance(each, ast.MatchMapping) and each.rest:
            yield each.rest


def catches(handler: ast.ExceptHandler) -> bool:
    """Return whether an undefined name would be caught."""
    return handler.type is None or any(
        isinstance(node, ast.Name) and node.id in CATCHES for node in nodes_of(handler.type)
    )

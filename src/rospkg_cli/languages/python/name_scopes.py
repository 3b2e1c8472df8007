"""Uses of names in Python that no scope around them binds."""

from __future__ import annotations

import ast
import builtins
from collections.abc import Iterable, Iterator

from .bindings import bindings
from .nodes import children_of, nodes_of

GIVEN = frozenset(dir(builtins)) | frozenset(
    "__file__ __name__ __doc__ __package__ __loader__ __spec__ __builtins__ __path__ __cached__ __annotations__".split()
)
SCOPES = frozenset({
    ast.FunctionDef, ast.AsyncFunctionDef, ast.Lambda, ast.ClassDef, ast.ListComp, ast.SetComp, ast.DictComp,
    ast.GeneratorExp, ast.AnnAssign, ast.Try, ast.ExceptHandler, ast.Match,
})  # fmt: skip
"""Nodes whose parts see other names, or are not all looked at."""

BINDING = frozenset({ast.Global, ast.Nonlocal, ast.NamedExpr, ast.ExceptHandler, ast.Match})
"""Nodes that bind names wherever in a scope they are."""

FunctionNode = ast.FunctionDef | ast.AsyncFunctionDef | ast.Lambda

Found = tuple[ast.Name, frozenset[str]]
Part = tuple[Iterable[ast.AST | None], frozenset[str]]
"""Some nodes, and the names that they see."""


def names_unseen(body: Iterable[ast.AST], top: frozenset[str]) -> Iterator[Found]:
    """Yield the uses of names in the body of a module that their scopes don't see, in the order of the text."""
    waiting: list[tuple[ast.AST | None, frozenset[str]]] = [(node, top) for node in [*body][::-1]]
    while waiting:  # without recursion, as every expression is looked through
        node, seen = waiting.pop()
        if isinstance(node, ast.Name):
            if node.id not in seen and node.id not in GIVEN and isinstance(node.ctx, ast.Load):
                yield node, seen
        elif node.__class__ in SCOPES:
            parts = [(each, names) for nodes, names in parts_of(node, seen) for each in nodes]
            waiting += parts[::-1]
        elif node is not None:
            waiting += [(each, seen) for each in children_of(node)[::-1]]


def parts_of(node: ast.AST | None, seen: frozenset[str]) -> Iterator[Part]:
    """Yield the parts of a node, each with the names that it sees."""
    match node:
        case ast.FunctionDef() | ast.AsyncFunctionDef() | ast.Lambda():
            yield from parts_of_function(node, seen)
        case ast.ClassDef():
            yield [*node.decorator_list, *node.bases, *node.keywords], seen
            yield from parts_of_class(node, seen)
        case ast.ListComp() | ast.SetComp() | ast.DictComp() | ast.GeneratorExp():
            inner = seen | {name for each in node.generators for name, _ in bindings([each.target])}
            yield children_of(node), inner
        case ast.AnnAssign():
            yield [node.target, node.value], seen
        case ast.Try() if any(map(catches, node.handlers)):
            yield [*node.handlers, *node.finalbody], seen
        case ast.ExceptHandler(name=str(name)):
            yield [node.type, *node.body], seen | {name}
        case ast.Match():
            yield children_of(node), seen | set(captured(node))
        case ast.AST():
            yield children_of(node), seen


def parts_of_function(node: FunctionNode, seen: frozenset[str], around: frozenset[str] | None = None) -> Iterator[Part]:
    """Yield the parts of a function; `around` are the names that its decorators and defaults see, if not `seen`."""
    arguments, outside = node.args, seen if around is None else around
    yield [*arguments.defaults, *arguments.kw_defaults], outside
    seen |= type_parameters(node)
    every = [*arguments.posonlyargs, *arguments.args, *arguments.kwonlyargs, arguments.vararg, arguments.kwarg]
    own = {each.arg for each in every if each is not None}
    body = [node.body] if isinstance(node, ast.Lambda) else node.body
    if not isinstance(node, ast.Lambda):
        yield node.decorator_list, outside
        yield [*(each.annotation for each in every if each), node.returns], outside | type_parameters(node)
    yield body, seen | own | bound_in(body)


def parts_of_class(node: ast.ClassDef, seen: frozenset[str]) -> Iterator[Part]:
    """Yield the body of a class, whose names its own statements see and the bodies of its methods don't."""
    seen |= type_parameters(node)
    own = seen | bound_in(node.body) | {"__class__", "__qualname__", "__module__"}
    for each in node.body:
        if isinstance(each, ast.FunctionDef | ast.AsyncFunctionDef):
            yield from parts_of_function(each, seen | {"__class__", "super"}, own)
        else:
            yield [each, each.annotation if isinstance(each, ast.AnnAssign) else None], own


def type_parameters(node: ast.AST) -> frozenset[str]:
    """Return the names of `class Box[T]`, which Python 3.12 and later know."""
    return frozenset(each.name for each in getattr(node, "type_params", ()))


def bound_in(body: Iterable[ast.AST]) -> frozenset[str]:
    """Return the names that a scope binds, also by `global` (then some scope of the file does), `except`, `match`."""
    body = list(body)
    names = {name for name, _ in bindings(body)}
    binding = [node for each in body for node in nodes_of(each) if node.__class__ in BINDING]
    for node in binding:
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
    """Return whether an undefined name is expected."""
    return handler.type is not None and any(
        isinstance(node, ast.Name) and node.id == "NameError" for node in nodes_of(handler.type)
    )

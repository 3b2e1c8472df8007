"""Names that a Python file uses and that nothing in it defines or imports."""

from __future__ import annotations

import ast
import builtins
from collections.abc import Iterable, Iterator

from ...light_dataclasses import dataclass
from ...source import Span
from .bindings import bindings
from .constant_truth import unreached_statements
from .file import PythonFile
from .guarded_nodes import guarded_nodes
from .nodes import children_of, nodes_of, nodes_of_kind
from .unread_types import told_types

GIVEN = frozenset(dir(builtins)) | frozenset(
    "__file__ __name__ __doc__ __package__ __loader__ __spec__ __builtins__ __path__ __cached__ __annotations__".split()
)
BROAD = frozenset({"Exception", "BaseException"})

SCOPES = frozenset({
    ast.FunctionDef, ast.AsyncFunctionDef, ast.Lambda, ast.ClassDef, ast.ListComp, ast.SetComp, ast.DictComp,
    ast.GeneratorExp, ast.AnnAssign, ast.Try, ast.ExceptHandler, ast.Match,
})  # fmt: skip
"""The classes of nodes whose parts see other names, or are not all looked at."""

BINDING = frozenset({ast.Global, ast.Nonlocal, ast.NamedExpr, ast.ExceptHandler, ast.Match})
"""What binds names wherever it stands in a scope."""

FunctionNode = ast.FunctionDef | ast.AsyncFunctionDef | ast.Lambda


@dataclass(frozen=True, slots=True)
class UndefinedName:
    """A use of a name that no scope binds."""

    name: str
    span: Span
    known: frozenset[str]
    """The names that are bound there, without builtins."""
    is_annotation: bool = False
    """Whether it says a type, which Python reads as it defines the function or the class, from 3.14 on never."""
    is_caught: bool = False
    """Whether it is in a `try` that catches every exception."""


def undefined_names(file: PythonFile, *, everywhere: bool = False, with_types: bool = False) -> Iterator[UndefinedName]:
    """Yield uses of names that no scope around them binds; none where a file may have names that it does not show.

    With types: also in annotations. Everywhere: there, where any exception is caught, and in files with star imports,
    of which whoever asks knows what they bring.
    """
    if file.has_dynamic_names or (not everywhere and any("*" in each.names for each in file.imports)):
        return
    if any(node.id in ("exec", "eval", "locals") for node in nodes_of_kind(file.tree, ast.Name)):
        return
    found = [*names_unseen(file.tree.body, frozenset(file.definitions))]
    annotations = frozenset(annotated(file)) if found else frozenset()
    caught = frozenset(guarded_nodes(file.tree.body, BROAD)) if found else frozenset()
    for name, known in found:
        each = UndefinedName(name.id, file.span(name), known, id(name) in annotations, id(name) in caught)
        is_read = not each.is_annotation or "annotations" not in file.definitions
        is_asked = everywhere or (not each.is_caught and (with_types or not each.is_annotation))
        if is_asked and is_read:
            yield each


def annotated(file: PythonFile) -> Iterator[int]:
    """Yield the identity of each node in an annotation."""
    yield from (id(node) for each in told_types(file) for node in nodes_of(each))


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


def is_passed_over(file: PythonFile, span: Span) -> bool:
    """Return whether a place is in a branch of a condition on a constant, or behind what leaves its block."""
    statements = unreached_statements(nodes_of(file.tree), file.constants)
    return any(file.span(each).contains(span) for each in statements)


def is_run(file: PythonFile, span: Span) -> bool:
    """Return whether Python surely comes to a place: it stands in a plain statement of the top level."""
    plain = (file.span(node) for node in file.tree.body if isinstance(node, ast.Expr | ast.Assign))
    return any(each.contains(span) for each in plain)


def is_in_function(file: PythonFile, span: Span) -> bool:
    """Return whether a place lies in a function, which may not be called."""
    spans = (file.span(node) for node in nodes_of(file.tree) if isinstance(node, FunctionNode))
    return any(each.holds(span) for each in spans)


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

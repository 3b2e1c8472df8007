"""What a function that launch calls reads or sets in `context.launch_configurations`, a dict by name."""

from __future__ import annotations

import ast
from collections.abc import Iterator

from ...languages.python.nodes import children_of, nodes_of
from ...languages.python.syntax import PythonSyntax
from ...light_dataclasses import dataclass
from ...source import Span
from .configuration_events import LaunchEvent
from .text import LaunchText, Literal

DICT = "launch_configurations"
BRANCHES = (
    ast.If, ast.IfExp, ast.Try, ast.For, ast.While, ast.BoolOp, ast.FunctionDef, ast.Lambda,
    ast.ListComp, ast.SetComp, ast.DictComp, ast.GeneratorExp,
)  # fmt: skip


@dataclass(frozen=True, slots=True)
class Lookup:
    name: str
    span: Span
    is_optional: bool
    """Whether it asks for the name, or has a value where there is none."""


def lookup(node: ast.AST, file: PythonSyntax) -> Lookup | None:
    """Return the lookup that an expression is: `[name]`, `.get(name)`, `name in`; None for anything else."""
    match node:
        case ast.Subscript(value=ast.Attribute(attr=attr), slice=ast.Constant(value=str(name)) as key, ctx=ast.Load()):
            return Lookup(name, file.span(key), False) if attr == DICT else None
        case ast.Call(
            func=ast.Attribute(value=ast.Attribute(attr=attr), attr="get"), args=[ast.Constant(value=str(name)), *_]
        ):
            return Lookup(name, file.span(node), True) if attr == DICT else None
        case ast.Compare(
            left=ast.Constant(value=str(name)), ops=[ast.In() | ast.NotIn()], comparators=[ast.Attribute(attr=attr)]
        ):
            return Lookup(name, file.span(node), True) if attr == DICT else None
    return None


def has_other_use(file: PythonSyntax) -> bool:
    """Return whether a file does anything else with the dict, such as setting a name in it."""
    nodes = list(nodes_of(file.tree))
    every = sum(isinstance(node, ast.Attribute) and node.attr == DICT for node in nodes)
    return every != sum(lookup(node, file) is not None for node in nodes) or f"'{DICT}'" in file.source.text


def names_set(file: PythonSyntax) -> Iterator[LaunchText]:
    """Yield the literal names that a file sets in the dict: `[name] = value`, `.update({name: value})`."""
    for node in nodes_of(file.tree) if DICT in file.source.text else ():
        for key in keys_set(node):
            if isinstance(key, ast.Constant) and isinstance(key.value, str):
                yield LaunchText(file.span(key), (Literal(key.value, file.span(key)),))


def keys_set(node: ast.AST) -> list[ast.expr | None]:
    match node:
        case ast.Subscript(value=ast.Attribute(attr=attr), slice=key, ctx=ast.Store()) if attr == DICT:
            return [key]
        case ast.Call(func=ast.Attribute(value=ast.Attribute(attr=attr), attr="update"), args=[ast.Dict(keys=keys)]):
            return keys if attr == DICT else []
    return []


def lookups(function: ast.AST, file: PythonSyntax) -> Iterator[LaunchEvent]:
    """Yield the uses of launch configurations that a function looks up; under a condition they are optional."""
    for node, certain in walked(function, True):
        found = lookup(node, file)
        if found is not None:
            yield LaunchEvent("use", found.name, found.span, found.is_optional or not certain, is_lookup=True)


def walked(root: ast.AST, certain: bool) -> Iterator[tuple[ast.AST, bool]]:
    """Yield all nodes below one, in order, each with whether no condition is around it."""
    waiting = [(root, certain)]
    while waiting:
        node, is_certain = waiting.pop()
        if node is not root:
            yield node, is_certain
        waiting += [(child, is_certain and not isinstance(child, BRANCHES)) for child in reversed(children_of(node))]

"""Functions of a Python launch file that nothing there names: launch never runs them."""

from __future__ import annotations

import ast
from collections.abc import Iterable, Iterator
from typing import cast

from ...languages.python.constant_truth import unreached_nodes
from ...languages.python.file import PythonFile
from ...languages.python.nodes import FunctionNode, nodes_of, nodes_of_kind
from ...source import Span

ENTRY = "generate_launch_description"
BY_NAME = frozenset({"globals", "locals", "vars", "getattr", "eval", "exec"})
"""Functions that find another one by a name that need not stand in the code."""


def uncalled_functions(file: PythonFile) -> tuple[Span, ...]:
    """Return the functions that launch never calls; none of a file without an entry point, which others import."""
    return tuple(map(file.span, uncalled(file)))


def uncalled_bodies(file: PythonFile) -> Iterator[Span]:
    """Yield what only a call of such a function runs: neither its decorators nor the defaults of its arguments."""
    yield from bodies(file, uncalled(file))


def bodies(file: PythonFile, functions: Iterable[FunctionNode]) -> Iterator[Span]:
    for each in functions:
        yield Span(file.span(each.body[0]).start, file.span(each.body[-1]).end)


def uncalled(file: PythonFile) -> tuple[FunctionNode, ...]:
    known = vars(file)
    if "uncalled" not in known:  # asked for every action of the file
        known["uncalled"] = tuple(unnamed(file)) if ENTRY in file.functions else ()
    return cast("tuple[FunctionNode, ...]", known["uncalled"])


def unnamed(file: PythonFile) -> list[FunctionNode]:
    """Return the functions that no code names but their own, and that of others like them."""
    unreached = {*unreached_nodes(nodes_of(file.tree), file.constants)}
    words = [(id(node), word) for node in nodes_of(file.tree) if id(node) not in unreached for word in words_of(node)]
    found: list[FunctionNode] = []
    waiting = list(candidates(file)) if BY_NAME.isdisjoint(word for _, word in words) else []
    while waiting:
        own = {each.name: {id(node) for node in nodes_of(each)} for each in waiting}
        lost = [each for each in waiting if all(at in own[each.name] for at, word in words if word == each.name)]
        if not lost:
            break
        inside = {at for each in lost for at in own[each.name]}
        words = [(at, word) for at, word in words if at not in inside]
        waiting = [each for each in waiting if each not in lost]
        found += lost
    return found


def candidates(file: PythonFile) -> Iterator[FunctionNode]:
    """Yield the functions of the file, and methods of classes that extend no other, whose caller is known then."""
    bodies = [file.tree.body, *(each.body for each in nodes_of_kind(file.tree, ast.ClassDef) if not each.bases)]
    for node in (each for body in bodies for each in body):
        is_plain = isinstance(node, FunctionNode) and not node.decorator_list
        if isinstance(node, FunctionNode) and is_plain and node.name != ENTRY and not node.name.startswith("__"):
            yield node


def words_of(node: ast.AST) -> tuple[str, ...]:
    """Return the name that a node reads, or asks an object for; of a text all that may be one."""
    match node:
        case ast.Name(id=name, ctx=ast.Load()) | ast.Attribute(attr=name):
            return (name,)
        case ast.Constant(value=str() as text):
            return (text,)
    return ()

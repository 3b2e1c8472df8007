"""What functions bind to local names that nothing reads: an action that is made and never added."""

from __future__ import annotations

import ast
from collections import Counter
from collections.abc import Iterable, Iterator, Set
from typing import cast

from ...source import Span
from .bound_again import bound_again
from .constant_truth import unreached_nodes
from .file import PythonFile
from .idle_statements import filling_calls, idle_tests
from .nodes import nodes_below, nodes_of, nodes_of_kind

BoundValue = tuple[list[str], ast.expr]
"""Names, and what is bound to them."""


def never_added(file: PythonFile) -> tuple[Span, ...]:
    """Return the values in functions that nothing reads: bound to a local, perhaps for a while, or to nothing.

    So are conditions of an `if` that only chooses among such values, and what is put into a list that nothing reads.
    """
    known = vars(file)
    if "never_added" not in known:  # asked for every action of the file
        known["never_added"] = tuple(dict.fromkeys(unread_values(file)))
    return cast("tuple[Span, ...]", known["never_added"])


def unread_values(file: PythonFile, shown: Set[int] = frozenset(), more: Iterable[BoundValue] = ()) -> Iterator[Span]:
    """Yield the values, where the reads whose identities are given count for none; of `more` as well."""
    loads = [node for node in nodes_of_kind(file.tree, ast.Name) if not is_stored(node) and id(node) not in shown]
    again = {id(node) for node in loads_for_itself(file)} | {*unreached_nodes(nodes_of(file.tree), file.constants)}
    loads = [node for node in loads if id(node) not in again]
    if any(node.id == "locals" for node in loads):
        return
    filled = list(filling_calls(file))
    itself = {id(name) for name, _ in filled}
    loads = [node for node in loads if id(node) not in itself]
    waiting = [*local_values(file), *(([name.id], call) for name, call in filled), *more]
    replaced = {id(each.value) for each in bound_again(file)}
    gone: set[int] = set()
    while True:  # what only such a value reads is not read either
        read = {node.id for node in loads}
        lost = [value for names, value in waiting if read.isdisjoint(names) or id(value) in replaced]
        gone |= {id(value) for value in lost}
        lost += idle_tests(file, gone) if gone else ()
        gone |= {id(value) for value in lost}
        if not lost:
            return
        yield from map(file.span, lost)
        inside = {id(node) for value in lost for node in nodes_below(value)} | {id(value) for value in lost}
        loads = [node for node in loads if id(node) not in inside]
        waiting = [(names, value) for names, value in waiting if value not in lost]


def only_read_in(file: PythonFile, spans: Iterable[Span]) -> Iterator[Span]:
    """Yield the values of names that are bound once, and that only what stands in some spans, or in these, reads."""
    lost = list(spans)
    loads = [node for node in nodes_of_kind(file.tree, ast.Name) if not is_stored(node)]
    stored = Counter(node.id for node in nodes_of_kind(file.tree, ast.Name) if is_stored(node))
    named = {node.id for node in loads}  # what nothing reads here, others may import
    waiting = [(names[0], value) for names, value in bound_values(file) if len(names) == 1 and stored[names[0]] == 1]
    waiting = [(name, value) for name, value in waiting if name in named]
    if any(node.id in ("locals", "globals") for node in loads):
        return
    while True:
        loads = [each for each in loads if not any(span.contains(file.span(each)) for span in lost)]
        read = {each.id for each in loads}
        lost = [file.span(value) for name, value in waiting if name not in read]
        waiting = [(name, value) for name, value in waiting if name in read]
        yield from lost
        if not lost:
            return


def bound_values(file: PythonFile) -> Iterator[BoundValue]:
    """Yield what functions and the module bind to plain names, with these."""
    yield from local_values(file)
    yield from module_values(file)


def module_values(file: PythonFile) -> Iterator[BoundValue]:
    """Yield what the module itself binds to one plain name, with this."""
    for node in file.tree.body:
        match node:
            case ast.Assign(targets=[ast.Name(id=name)], value=value):
                yield [name], value
            case ast.AnnAssign(target=ast.Name(id=name), value=ast.expr() as value):
                yield [name], value


def local_values(file: PythonFile) -> Iterator[BoundValue]:
    """Yield what functions bind to plain names, with these."""
    for function in nodes_of_kind(file.tree, ast.FunctionDef):
        for node in nodes_below(function):
            if isinstance(node, ast.Assign):
                names = [target.id for target in node.targets if isinstance(target, ast.Name)]
                if len(names) == len(node.targets):
                    yield names, node.value
            elif isinstance(node, ast.AnnAssign) and isinstance(node.target, ast.Name) and node.value is not None:
                yield [node.target.id], node.value


def loads_for_itself(file: PythonFile) -> Iterator[ast.Name]:
    """Yield the reads of a name in what is made of it and bound to it again: `path = Replaced(path)`."""
    for node in nodes_of_kind(file.tree, ast.Assign):
        match node:
            case ast.Assign(targets=[ast.Name(id=name)], value=ast.Call(func=ast.Name(id=made)) as value):
                if made[:1].isupper():
                    yield from (n for n in nodes_below(value) if isinstance(n, ast.Name) and n.id == name)


def is_stored(name: ast.Name) -> bool:
    return isinstance(name.ctx, ast.Store)

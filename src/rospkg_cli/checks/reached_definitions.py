"""Rule input: the functions, methods and classes of a package that its programs lead to, by their names."""

from __future__ import annotations

import ast
from collections.abc import Iterator, Mapping, Sequence
from functools import cached_property

from ..languages.python.file import PythonFile
from ..languages.python.nodes import FunctionNode, children_of, nodes_of
from ..light_dataclasses import dataclass
from ..package.install_table import InstallTable
from ..source import Span
from .logged_texts import logged_texts
from .run_imports import RunImports

Definition = FunctionNode | ast.ClassDef
OF_NODES = frozenset({"Node", "LifecycleNode"})
EMPTY = frozenset({"object", "ABC", "Protocol"})
CALLED_BY_ROS = ("__", "on_", "destroy_node", "generate_")
"""How methods and functions begin that Python or ROS calls by itself."""


@dataclass(frozen=True, slots=True)
class Named:
    """A definition, and what it leads to where something leads to it."""

    node: Definition
    names: frozenset[str]
    """That its own code mentions, without the definitions in it."""
    by_others: tuple[Named, ...]
    """The methods of a class that code of others may call by their names, once there is an object."""


@dataclass(frozen=True)
class ReachedDefinitions:
    run: RunImports
    table: InstallTable

    def leads_to(self, file: PythonFile, span: Span) -> bool:
        """Return whether programs lead to all definitions around a place in a function, as far as names tell.

        A mention of its name leads to a definition. Without programs, whoever imports a module calls what is there.
        The body of a class runs wherever the class stands.
        """
        around = [each for each in self.of_files.get(file.path, ()) if file.span(each.node).holds(span)]
        bodies = (each.node.body[0] for each in around if isinstance(each.node, FunctionNode))
        is_inside = any(file.span(first).start <= span.start for first in bodies)
        return not is_inside or all(id(each.node) in self.reached for each in around)

    @cached_property
    def of_files(self) -> dict[str, tuple[Named, ...]]:
        return {file.path: tuple(definitions(file)) for _, file in self.run.files}

    @cached_property
    def entries(self) -> frozenset[str]:
        """The names of functions that entry points call."""
        return frozenset(row.entry.partition(":")[2].partition(".")[0] for row in self.table.of("executable"))

    @cached_property
    def reached(self) -> frozenset[int]:
        """The identity of each definition that is led to."""
        every: dict[str, list[Named]] = {}
        for each in (one for found in self.of_files.values() for one in found):
            every.setdefault(each.node.name, []).append(each)
        waiting = [each for name in self.entries for each in every.get(name, ())]
        waiting += [each for found in every.values() for each in found if self.is_start(each)]
        names = {name for _, file in self.run.files for name in own_names(file, file.tree)}
        waiting += [each for name in names for each in meant(name, every)]
        found: set[int] = set()
        while waiting:
            each = waiting.pop()
            if id(each.node) not in found:
                found.add(id(each.node))
                waiting += each.by_others
                waiting += [one for name in each.names for one in meant(name, every)]
        return frozenset(found)

    def is_start(self, each: Named) -> bool:
        """Return whether a definition counts as called: by a decorator, a framework, or who imports the package."""
        has_programs = bool(self.entries) or any(True for _ in self.table.of("executable"))
        name = each.node.name
        return bool(each.node.decorator_list) or name.startswith(("test", "Test")) or not has_programs


def meant(name: str, every: Mapping[str, Sequence[Named]]) -> Iterator[Named]:
    """Yield the definitions that a name or text may mean: `do_` is the beginning of one that is put together."""
    yield from every.get(name, ())
    if name.endswith("_") and name.strip("_"):
        yield from (each for full, found in every.items() if full.startswith(name) for each in found)


def definitions(file: PythonFile) -> Iterator[Named]:
    """Yield the definitions of a file, wherever they stand."""
    found: dict[int, Named] = {}
    for node in reversed([each for each in nodes_of(file.tree) if isinstance(each, Definition)]):
        called: tuple[Named, ...] = ()
        if isinstance(node, ast.ClassDef):
            inner = [found[id(each)] for each in node.body if id(each) in found]
            called = tuple(each for each in inner if is_open(node) or each.node.name.startswith(CALLED_BY_ROS))
        found[id(node)] = Named(node, frozenset(own_names(file, node)), called)
    yield from found.values()


def is_open(node: ast.ClassDef) -> bool:
    """Return whether code of others may call the methods of a class: it has a base of theirs, but for a node's."""
    last = {ast.unparse(base).rpartition(".")[2] for base in node.bases}
    return bool(last - OF_NODES - EMPTY) or bool(node.keywords)


def own_names(file: PythonFile, scope: ast.AST) -> Iterator[str]:
    """Yield the names and strings that a scope mentions, without the bodies of definitions in it and without logs."""
    logged = logged_texts(file)
    waiting = children_of(scope)
    while waiting:
        node = waiting.pop()
        match node:
            case ast.Name(id=name) | ast.Attribute(attr=name):
                yield name
            case ast.Constant(value=str(name)) if id(node) not in logged:
                yield name
            case ast.alias(name=name):
                yield name
        if isinstance(node, FunctionNode):
            waiting += [node.args, *node.decorator_list]
        elif isinstance(node, ast.ClassDef):
            waiting += [*node.bases, *node.decorator_list]
        else:
            waiting += children_of(node)

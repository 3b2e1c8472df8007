"""The classes of a package whose every base is known, so that it is known what their objects have."""

from __future__ import annotations

import ast
from collections import Counter
from collections.abc import Iterator
from functools import cached_property

from ...languages.python.file import PythonFile
from ...languages.python.nodes import nodes_of_kind
from ...light_dataclasses import dataclass
from ..python.installed_modules import InstalledModules
from ..python.node_bases import is_of_rclpy, origins
from ..python.run_imports import RunImports

EMPTY = frozenset({"object", "ABC"})
DEPTH = 8
SHAPING = frozenset({"dataclass", "dataclasses.dataclass", "total_ordering", "final"})
"""Decorators that remove nothing from a class."""


@dataclass(frozen=True, slots=True)
class OwnClass:
    file: PythonFile
    node: ast.ClassDef


@dataclass(frozen=True, slots=True)
class Line:
    """A class and all of its bases that the package has."""

    classes: tuple[OwnClass, ...]
    is_node: bool


@dataclass(frozen=True)
class OwnClasses:
    run: RunImports
    installed: InstalledModules

    @cached_property
    def all(self) -> tuple[OwnClass, ...]:
        """The classes at the top level of the package's files."""
        files = (file for _, file in self.run.files)
        return tuple(
            OwnClass(file, each) for file in files for each in file.tree.body if isinstance(each, ast.ClassDef)
        )

    @cached_property
    def created(self) -> frozenset[str]:
        """The names of everything that is called: classes with objects are among them."""
        calls = (each.func for _, file in self.run.files for each in nodes_of_kind(file.tree, ast.Call))
        return frozenset(last_name(each) for each in calls)

    def has_objects(self, owner: OwnClass) -> bool:
        """Return whether code calls a class, in its own file where another one has its name."""
        name = owner.node.name
        alone = self.of_name[name] == 1
        calls = () if alone else nodes_of_kind(owner.file.tree, ast.Call)
        return name in self.created and (alone or any(last_name(each.func) == name for each in calls))

    @cached_property
    def of_name(self) -> Counter[str]:
        """How many classes have a name."""
        return Counter(each.node.name for each in self.all)

    @cached_property
    def bindings(self) -> dict[str, Counter[str]]:
        return {}

    def times_bound(self, file: PythonFile, name: str) -> int:
        """Return how often a file binds a name at any level."""
        if file.path not in self.bindings:
            self.bindings[file.path] = bindings(file)
        return self.bindings[file.path][name]

    def line(self, owner: OwnClass, depth: int = 0) -> Line | None:
        """Return a class with its bases; None where one of these is not known."""
        is_shaped = any(ast.unparse(each).partition("(")[0] not in SHAPING for each in owner.node.decorator_list)
        if depth > DEPTH or owner.node.keywords or is_shaped or self.times_bound(owner.file, owner.node.name) != 1:
            return None
        found, is_node = [owner], False
        for base in owner.node.bases:
            match self.base(owner.file, base, depth):
                case Line() as line:
                    found += line.classes
                    is_node = is_node or line.is_node
                case "node":
                    is_node = True
                case "unknown":
                    return None
        return Line(tuple(found), is_node)

    def base(self, file: PythonFile, base: ast.expr, depth: int) -> Line | str:
        """Return what a base is: classes of the package, "node", "empty", or "unknown"."""
        text = ast.unparse(base)
        if self.times_bound(file, text) == 1 and (own := top_class(file, text)):
            return self.line(OwnClass(file, own), depth + 1) or "unknown"
        if is_of_rclpy(file, base):
            return "node"
        homes = origins(file, text)
        if text == "object" or (text == "ABC" and any(each.module == "abc" for each, _ in homes)):
            return "empty"
        sources = {(self.installed.sources.get(self.installed.absolute(each, file.path), ""), n) for each, n in homes}
        path, name = sources.pop() if len(sources) == 1 else ("", "")
        other = self.run.modules.at(path) if path else None
        own = top_class(other, name) if other is not None else None
        return (self.line(OwnClass(other, own), depth + 1) if other and own else None) or "unknown"

    def heirs(self, name: str) -> Iterator[OwnClass]:
        """Yield the classes that have a class of a name among their bases, or among those of these."""
        waiting, seen = [name], {name}
        for base in waiting:
            for each in self.all:
                if each.node.name not in seen and any(last_name(parent) == base for parent in each.node.bases):
                    seen.add(each.node.name)
                    waiting.append(each.node.name)
                    yield each


def top_class(file: PythonFile, name: str) -> ast.ClassDef | None:
    return next((each for each in file.tree.body if isinstance(each, ast.ClassDef) and each.name == name), None)


def bindings(file: PythonFile) -> Counter[str]:
    """Return how often a file binds each name at any level."""
    found = Counter(each.name for each in nodes_of_kind(file.tree, ast.ClassDef))
    found.update(each.name for each in nodes_of_kind(file.tree, ast.FunctionDef))
    found.update(each.id for each in nodes_of_kind(file.tree, ast.Name) if isinstance(each.ctx, ast.Store))
    found.update(each.asname or each.name for each in nodes_of_kind(file.tree, ast.alias))
    return found


def last_name(node: ast.expr) -> str:
    match node:
        case ast.Name(id=name) | ast.Attribute(attr=name):
            return name
        case ast.Subscript(value=value):
            return last_name(value)
    return ""

"""Methods of nodes that no code of the package names: nothing calls them, and nothing is registered with them."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from functools import cached_property

from ...languages.python.attributes import is_of_self
from ...languages.python.file import PythonFile
from ...languages.python.nodes import FunctionNode, nodes_of, nodes_of_kind
from ...light_dataclasses import dataclass
from ...source import Span
from ..paths.logged_texts import logged_texts
from ..python.class_families import class_families
from ..python.node_bases import is_of_rclpy
from ..python.run_imports import RunImports

FOR_ROS = frozenset({"destroy_node"})
"""Methods that rclpy calls by itself, with those of a life cycle (`on_configure`)."""


@dataclass(frozen=True)
class UncalledMethods:
    run: RunImports

    def has(self, path: str, span: Span) -> bool:
        """Return whether a place is in a method of a plain node whose name occurs nowhere else in the code."""
        file = self.run.modules.at(path)
        found = methods(file) if file is not None else ()
        return any(
            file is not None and file.span(each).holds(span) and not self.is_named(owner, each.name)
            for owner, each in found
        )

    def is_named(self, owner: str, name: str) -> bool:
        """Return whether code names a method of a class; `self.name` does within its class hierarchy."""
        return name in self.named or (self.families.get(owner, ""), name) in self.named_of_self

    @cached_property
    def families(self) -> dict[str, str]:
        return class_families(file for _, file in self.run.files)

    @cached_property
    def named_of_self(self) -> frozenset[tuple[str, str]]:
        """The members that methods name by `self`, each with the family of the class around."""
        owners = ((each, file) for _, file in self.run.files for each in nodes_of_kind(file.tree, ast.ClassDef))
        found = (
            (owner.name, node.attr)
            for owner, _ in owners
            for node in nodes_of_kind(owner, ast.Attribute)
            if is_of_self(node)
        )
        return frozenset((self.families[owner], name) for owner, name in found)

    @cached_property
    def named(self) -> frozenset[str]:
        """Every name and every string in the code of the package's files, but for members of `self` in a class.

        A comment or a log names nothing.
        """
        return frozenset(name for _, file in self.run.files for name in names_in(file))


def methods(file: PythonFile) -> Iterator[tuple[str, FunctionNode]]:
    """Yield the methods of classes that are a Node and nothing else, but for those that others may call unseen."""
    for owner in nodes_of_kind(file.tree, ast.ClassDef):
        is_plain = bool(owner.bases) and all(is_of_rclpy(file, each) for each in owner.bases)
        for each in owner.body if is_plain else ():
            if isinstance(each, FunctionNode) and not may_be_called_unseen(each):
                yield owner.name, each


def may_be_called_unseen(method: FunctionNode) -> bool:
    return method.name.startswith(("__", "on_")) or method.name in FOR_ROS or bool(method.decorator_list)


def names_in(file: PythonFile) -> Iterator[str]:
    logged = logged_texts(file)
    owners = nodes_of_kind(file.tree, ast.ClassDef)
    of_self = {id(node) for owner in owners for node in nodes_of_kind(owner, ast.Attribute) if is_of_self(node)}
    for node in (each for each in nodes_of(file.tree) if id(each) not in of_self):
        match node:
            case ast.Attribute(attr=name) | ast.Name(id=name):
                yield name
            case ast.Constant(value=str(name)) if id(node) not in logged:
                yield name

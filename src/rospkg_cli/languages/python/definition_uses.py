"""The functions and classes of a Python file, and where it mentions their names."""

from __future__ import annotations

import ast
from collections.abc import Sequence
from functools import cached_property

from ...light_dataclasses import dataclass
from ...source import Span
from .file import PythonFile
from .nodes import FunctionNode, nodes_of, nodes_of_kind
from .raising_regions import bodies, unit_at

Definition = FunctionNode | ast.ClassDef


@dataclass(frozen=True, slots=True)
class NameUse:
    name: str
    place: int
    unit: int
    """The identity of the function that mentions it; 0 for the module."""
    is_own_call: bool
    """Whether it is called of `self`, or handed to a thread."""


@dataclass(frozen=True)
class DefinitionUses:
    file: PythonFile

    @cached_property
    def bodies(self) -> list[tuple[Span, FunctionNode]]:
        return bodies(self.file)

    def unit(self, place: int) -> int:
        """Return the identity of the function around a place; 0 for the module."""
        found = unit_at(self.bodies, place)
        return id(found) if found is not None else 0

    @property
    def classes(self) -> list[ast.ClassDef]:
        return nodes_of_kind(self.file.tree, ast.ClassDef)

    @cached_property
    def definitions(self) -> tuple[Definition, ...]:
        return tuple(each for each in nodes_of(self.file.tree) if isinstance(each, Definition))

    @cached_property
    def named(self) -> dict[str, list[Definition]]:
        found: dict[str, list[Definition]] = {}
        for each in self.definitions:
            found.setdefault(each.name, []).append(each)
        return found

    @cached_property
    def methods(self) -> frozenset[int]:
        return frozenset(id(each) for owner in self.classes for each in owner.body)

    @cached_property
    def mentions(self) -> Sequence[NameUse]:
        calls = {id(each.func) for each in nodes_of_kind(self.file.tree, ast.Call)}
        calls |= {id(each.value) for each in nodes_of_kind(self.file.tree, ast.keyword) if each.arg == "target"}
        return [
            self.mention(each, calls) for each in nodes_of(self.file.tree) if isinstance(each, ast.Name | ast.Attribute)
        ]

    def mention(self, node: ast.Name | ast.Attribute, calls: set[int]) -> NameUse:
        span = self.file.span(node)
        place = span.start if isinstance(node, ast.Name) else span.end - len(node.attr)
        is_own = isinstance(node, ast.Attribute) and isinstance(node.value, ast.Name) and node.value.id == "self"
        name = node.id if isinstance(node, ast.Name) else node.attr
        return NameUse(name, place, self.unit(place), is_own and id(node) in calls)

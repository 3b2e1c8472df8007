"""Names that code takes from rclpy or from its own node, and that these do not have (DEP120)."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from functools import cached_property

from ...languages.python.attributes import attribute_span
from ...languages.python.branches import is_under_condition
from ...languages.python.file import PythonFile
from ...languages.python.nodes import nodes_of_kind
from ...languages.python.own_reads import own_calls, own_nodes
from ...languages.python.unreached_places import is_unreached
from ...languages.python.unread_types import all_annotations
from ...light_dataclasses import dataclass
from ...package.file_role import Role
from ...ros.rclpy_names import OF_ROSPY, members_of_nodes
from ...source import Span
from ...suggest import near_names
from ..python.node_bases import is_of_rclpy
from .own_members import members
from .undefined_uses import UndefinedUses
from .unknown_names_of_rclpy_module import FAR, of_module, public
from .use_times import When

DYNAMIC = ("setattr(", "__getattr__", "__dict__")
UNCALLED = {f"self.{name}": name for name in ("get_logger", "get_clock")}
"""Methods of nodes that are only of use when they are called."""


@dataclass(frozen=True, slots=True)
class UnknownName:
    file: PythonFile
    span: Span
    name: str
    owner: str
    """`rclpy`, `self`, or the method that is not called: `self.get_logger`."""
    better: str
    when: When


@dataclass(frozen=True)
class UnknownRclpyNames:
    uses: UndefinedUses

    @property
    def files(self) -> Iterator[tuple[Role, PythonFile]]:
        """The files that use rclpy and have no names that only a run can know."""
        for role, file in self.uses.run.files:
            if role != "aside" and "rclpy" in file.source.text and not file.has_dynamic_names:
                yield role, file

    def all(self) -> Iterator[UnknownName]:
        """Yield each name once a file."""
        for role, file in self.files:
            seen: set[str] = set()
            for node, owner, better in (*of_module(file), *self.of_nodes(file)):
                if node.attr not in seen and not is_unreached(file, file.span(node)):
                    seen.add(node.attr)
                    yield self.unknown(file, node, owner, better, is_test=role == "test")

    def unknown(
        self, file: PythonFile, node: ast.Attribute | ast.Name, owner: str, better: str, *, is_test: bool
    ) -> UnknownName:
        span = attribute_span(file, node) if isinstance(node, ast.Attribute) else file.span(node)
        read = file.span(node.value) if isinstance(node, ast.Attribute) else span
        is_certain = not is_test and read in self.uses.places.certain.spans(file) and not is_type(file, span)
        when: When = "certainly" if is_certain else self.uses.places.met(file, span)
        when = "branch" if when == "maybe" and is_under_condition(file, span) else when
        return UnknownName(file, span, name_of(node), owner, better, when)

    def of_nodes(self, file: PythonFile) -> Iterator[tuple[ast.Attribute, str, str]]:
        """Yield calls of methods that a class of a node does not have, and nearly has."""
        known = members_of_nodes()
        for owner in self.node_classes(file):
            for _, method in own_calls(owner):
                name = method.attr
                is_known = name in known or name.startswith("_") or name in self.defined
                near = [] if is_known or len(name) <= FAR * 3 else near_names(name, public(known), FAR)
                if near:
                    yield method, "self", OF_ROSPY.get(name, f"self.{near[0]}")
            yield from self.uncalled(owner)

    def node_classes(self, file: PythonFile) -> Iterator[ast.ClassDef]:
        """Yield the classes that have rclpy's nodes for bases alone, unless the file gives names to objects."""
        if any(word in file.source.text for word in DYNAMIC):
            return
        for owner in nodes_of_kind(file.tree, ast.ClassDef):
            if owner.bases and all(is_of_rclpy(file, base) for base in owner.bases):
                yield owner

    def uncalled(self, owner: ast.ClassDef) -> Iterator[tuple[ast.Attribute, str, str]]:
        """Yield what a class takes from a method of nodes as if that were no method: `self.get_logger.info`."""
        for attribute in own_nodes(owner):
            if not isinstance(attribute, ast.Attribute):
                continue
            method = ast.unparse(attribute.value) if isinstance(attribute.value, ast.Attribute) else ""
            if method in UNCALLED and UNCALLED[method] not in self.defined and not attribute.attr.startswith("_"):
                yield attribute, method, f"{method}().{attribute.attr}"

    @cached_property
    def defined(self) -> frozenset[str]:
        """What any class of the package has: a subclass may bring what its base calls."""
        owners = (each for _, file in self.uses.run.files for each in nodes_of_kind(file.tree, ast.ClassDef))
        return frozenset(name for each in owners for name in members(each))


def is_type(file: PythonFile, span: Span) -> bool:
    """Return whether a place is an annotation, which newer Pythons evaluate only on demand."""
    return any(file.span(each).holds(span) for each in all_annotations(file))


def name_of(node: ast.Attribute | ast.Name) -> str:
    return node.attr if isinstance(node, ast.Attribute) else node.id

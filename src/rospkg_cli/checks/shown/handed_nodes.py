"""Whether a file gives its nodes to code that is not seen, which may spin them."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from functools import cached_property

from ...languages.python.file import PythonFile
from ...languages.python.nodes import functions_of, last_name, nodes_of, nodes_of_kind
from ...languages.python.unread_types import all_annotations
from ...light_dataclasses import dataclass
from ...ros.imports import STANDARD
from ..behind_loops import is_behind_loop
from .steps import ASKING, Steps

KEEPS = ASKING | {
    *("__init__", "ActionClient", "ActionServer", "Subscriber", "Buffer", "TransformListener", "TransformBroadcaster"),
    *("StaticTransformBroadcaster", "str", "repr"),
}
"""Calls that are given a node, and do not spin it."""
MAKES = frozenset({"create_node", "Node", "LifecycleNode"})
PLAIN = frozenset({"object", "ABC", "Exception", "RuntimeError", "ValueError", "dict", "list"})
DECORATES = frozenset({
    "property", "staticmethod", "classmethod", "cached_property", "setter", "dataclass", "abstractmethod", "override",
    "lru_cache", "cache", "wraps", "contextmanager", "total_ordering", "unique",
})  # fmt: skip


@dataclass(frozen=True)
class HandedNodes:
    steps: Steps
    file: PythonFile

    @property
    def may_be_spun(self) -> bool:
        if self.has_unknown_kinds:
            return True
        handed = (each for each in self.mentions if id(each) not in self.kept and self.holds(each))
        return any(not is_behind_loop(self.steps.meanings, self.file, self.file.span(each)) for each in handed)

    @property
    def mentions(self) -> Iterator[ast.expr]:
        return (each for each in nodes_of(self.file.tree) if isinstance(each, ast.Name | ast.Attribute | ast.Call))

    def holds(self, node: ast.expr) -> bool:
        """Return whether an expression is an own object, its class, or a node of rclpy."""
        if isinstance(node, ast.Name | ast.Attribute) and not isinstance(node.ctx, ast.Load):
            return False
        if ast.unparse(node) == "self" or is_made(node) or ast.unparse(node) in self.variables:
            return True
        definition = self.steps.meanings.of(self.file, node)
        return bool(self.steps.objects.of(self.file, node)) or (
            definition is not None and isinstance(definition.node, ast.ClassDef)
        )

    @cached_property
    def variables(self) -> frozenset[str]:
        """What is given a node that rclpy makes."""
        stores = (each for each in nodes_of_kind(self.file.tree, ast.Assign) if is_made(each.value))
        return frozenset(ast.unparse(target) for each in stores for target in each.targets)

    @cached_property
    def kept(self) -> frozenset[int]:
        """The identities of the expressions that stand where nothing is handed on."""
        found = {id(inner) for each in all_annotations(self.file) for inner in nodes_of(each)}
        for node in nodes_of(self.file.tree):
            match node:
                case ast.Attribute(value=value):
                    found.add(id(value))
                case ast.Assign(value=ast.Call() as value) | ast.AnnAssign(value=ast.Call() as value):
                    found.add(id(value))
                case ast.Expr(value=value) | ast.If(test=value) | ast.UnaryOp(operand=value):
                    found.add(id(value))
                case ast.ClassDef(bases=parts):
                    found.update(map(id, parts))
                case ast.Compare(left=left, comparators=others):
                    found.update(map(id, (left, *others)))
                case ast.Call(func=called, args=given, keywords=named):
                    found.add(id(called))
                    is_keeping = last_name(called) in KEEPS
                    found.update(map(id, (*given, *(each.value for each in named))) if is_keeping else ())
        return frozenset(found)

    @property
    def has_unknown_kinds(self) -> bool:
        """Return whether a class has a base, or a function a decorator, that may do anything with a node."""
        owners = nodes_of_kind(self.file.tree, ast.ClassDef)
        decorated = (*owners, *functions_of(self.file.tree))
        if any(last_name(root_call(each)) not in DECORATES for one in decorated for each in one.decorator_list):
            return True
        return any(owner.keywords or not all(map(self.is_known, owner.bases)) for owner in owners)

    def is_known(self, base: ast.expr) -> bool:
        definition, name = self.steps.meanings.of(self.file, base), last_name(base)
        homes = {each.module.partition(".")[0] for each in self.file.imports if name in each.names}
        root = ast.unparse(base).partition(".")[0] if isinstance(base, ast.Attribute) else ""
        tops = homes or ({root} if root else set())
        return (
            definition is not None
            or (bool(tops) and all(top in STANDARD or top == "rclpy" for top in tops))
            or (not tops and name in PLAIN)
        )


def is_made(node: ast.AST) -> bool:
    return isinstance(node, ast.Call) and last_name(node.func) in MAKES


def root_call(node: ast.expr) -> ast.expr:
    return node.func if isinstance(node, ast.Call) else node

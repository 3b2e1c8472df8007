"""Fields that Python code sets or reads and that the message does not have (IDL010)."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from functools import cached_property

from ...languages.python.constant_truth import unreached_nodes
from ...languages.python.file import PythonFile
from ...languages.python.guarded_nodes import BLOCKS, guarded_nodes
from ...languages.python.imports import Import
from ...light_dataclasses import dataclass
from ...ros.interface_fields import ros1_fields
from ...ros.interfaces import KINDS
from ...source import Span
from ..python.run_imports import RunImports
from ..python.wrong_calls import CATCHES as TYPE_ERROR
from .field_names import is_generated, settable, similar
from .known_interfaces import KnownInterfaces
from .message_classes import MessageClasses, changed_messages, names_interfaces
from .message_scopes import MessageScopes
from .message_variables import Environment, held_by
from .variable_bindings import Bindings

CATCHES = frozenset({"AttributeError", "Exception", "BaseException"})
"""Exceptions whose handlers catch the use of an unknown field."""


@dataclass(frozen=True, slots=True)
class UnknownField:
    path: str
    span: Span
    """Where the name of the field is written."""
    message: str
    """`package/msg/Name`."""
    name: str
    near: str | None
    """The field that was probably intended."""
    is_keyword: bool
    """Whether it is a keyword of the constructor."""
    is_ros1: bool
    """Whether the message of ROS 1 has this field."""
    is_by_place: bool = False
    """Whether it is a positional argument of the constructor, which takes keywords alone; `name` is then empty."""


@dataclass(frozen=True)
class UnknownFields:
    known: KnownInterfaces
    run: RunImports

    def unknown(self) -> Iterator[UnknownField]:
        """Yield the unknown fields of each file, in the order of its text."""
        for file in self.run.running:
            if any(imports_interfaces(each) for each in file.imports) and names_interfaces(file):
                classes = MessageClasses(file)
                found = {each.span: each for each in self.in_file(file, classes)}
                yield from (found[span] for span in sorted(found))

    def in_file(self, file: PythonFile, classes: MessageClasses) -> Iterator[UnknownField]:
        for body, variables in MessageScopes(file, classes, self.known.fields).bodies():
            yield from self.in_body(file, body, variables, classes)

    def in_body(
        self, file: PythonFile, body: Bindings, variables: Environment, classes: MessageClasses
    ) -> Iterator[UnknownField]:
        """Yield the unknown fields in the statements of one function, or of the module outside of functions."""
        ignored = set(guarded_nodes((node for node in body.nodes if isinstance(node, BLOCKS)), CATCHES))
        ignored.update(unreached_nodes(body.nodes, file.constants))
        caught = frozenset(guarded_nodes((node for node in body.nodes if isinstance(node, BLOCKS)), TYPE_ERROR))
        for node in body.nodes:
            if id(node) in ignored:
                continue
            if isinstance(node, ast.Attribute):
                message = held_by(node.value, variables, classes, self.known.fields)
                if node.attr.isupper() and not message:
                    message = classes.message(node.value)
                if message:
                    end = file.span(node).end
                    span = Span(end - len(node.attr), end)
                    is_set = isinstance(node.ctx, ast.Store)
                    yield from self.invalid(file.path, span, message, node.attr, is_set=is_set)
            elif isinstance(node, ast.Call) and (message := classes.message(node.func)):
                if id(node) not in caught and "rospy" not in file.source.text:
                    yield from self.by_place(file, node, message)
                for keyword in node.keywords:
                    if keyword.arg is not None:
                        start = file.span(keyword).start
                        span = Span(start, start + len(keyword.arg))
                        yield from self.invalid(file.path, span, message, keyword.arg, is_set=True, is_keyword=True)

    @cached_property
    def changed(self) -> frozenset[str]:
        """The messages whose classes get attributes from a module of the package: `Point.norm = norm`."""
        every = (changed_messages(file) for file in self.run.running if names_interfaces(file))
        return frozenset(each for found in every for each in found)

    def by_place(self, file: PythonFile, call: ast.Call, message: str) -> Iterator[UnknownField]:
        """Yield the first positional argument of the constructor of a message."""
        given = next((each for each in call.args if not isinstance(each, ast.Starred)), None)
        if given is not None and self.known.fields(message) is not None:
            yield UnknownField(file.path, file.span(given), message, "", None, False, False, is_by_place=True)

    def invalid(
        self, path: str, span: Span, message: str, name: str, *, is_set: bool, is_keyword: bool = False
    ) -> Iterator[UnknownField]:
        """Yield a name that a message does not have as a field; nothing where the fields may be others than known."""
        fields = self.known.fields(message) if message else None
        if fields is None or name in fields or is_generated(message, name):
            return
        is_ros1 = name in ros1_fields(message)
        here = self.known.is_here(message.partition("/")[0])
        near = similar(name, settable(fields) if is_set else fields, is_certain=here)
        if (near or is_ros1 or here) and message not in self.changed:
            yield UnknownField(path, span, message, name, near, is_keyword, is_ros1)


def imports_interfaces(each: Import) -> bool:
    """Return whether an import is of messages, services or actions, or may be."""
    kind = each.module.partition(".")[2]
    return kind in KINDS or (not kind and not any(name in KINDS for name in each.names))

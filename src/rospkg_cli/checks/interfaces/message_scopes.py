"""The bodies of a file's functions, each with the variables that hold a message in it."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from functools import cached_property

from ...languages.python.file import PythonFile
from ...languages.python.nodes import FunctionNode, last_name, nodes_of_kind
from ...light_dataclasses import dataclass
from .callback_types import callback_types
from .handed_objects import handed_objects
from .message_classes import MessageClasses
from .message_variables import Environment, Fields, asked_names, attributes_of, variables_of
from .variable_bindings import Bindings

Body = tuple[Bindings, Environment]
"""A function or a file, and the variables that hold a message in it."""
FUNCTIONS: tuple[type[FunctionNode], ...] = (ast.FunctionDef, ast.AsyncFunctionDef)


@dataclass(frozen=True)
class MessageScopes:
    file: PythonFile
    classes: MessageClasses
    fields: Fields

    def bodies(self) -> Iterator[Body]:
        """Yield the file's own statements and those of each function that may have to do with a message."""
        top = Bindings(self.file.tree.body)
        yield top, variables_of(top, {}, self.classes, self.fields)
        owned: set[int] = set()
        for owner in nodes_of_kind(self.file.tree, ast.ClassDef):
            methods = [each for each in owner.body if isinstance(each, FunctionNode)]
            owned |= {id(each) for each in methods}
            yield from self.of_class(owner, methods)
        functions = (each for kind in FUNCTIONS for each in nodes_of_kind(self.file.tree, kind))
        for function in (each for each in functions if id(each) not in owned):
            held = local(self.variables_in(function, ""))
            if held or self.classes.may_be_named_in(function):
                yield self.bindings(function), held

    def of_class(self, owner: ast.ClassDef, methods: list[FunctionNode]) -> Iterator[Body]:
        named: list[tuple[FunctionNode, Environment]] = [
            (each, self.variables_in(each, owner.name)) for each in methods
        ]
        may_hold = any(variables or self.classes.may_be_named_in(each) for each, variables in named)
        bound = ((self.bindings(each), variables) for each, variables in named) if may_hold else ()
        shared = attributes_of(owner, [*bound], self.classes, self.fields) if may_hold else {}
        for each, variables in named:
            asked = set(asked_names(each.body)) if shared else ()
            held = {**{name: kind for name, kind in shared.items() if name not in asked}, **local(variables)}
            if held or self.classes.may_be_named_in(each):
                yield self.bindings(each), held

    def variables_in(self, function: FunctionNode, owner: str) -> Environment:
        given = self.signatures.parameters(function, owner)
        is_of_interest = given or self.classes.may_be_named_in(function)
        return variables_of(self.bindings(function), given, self.classes, self.fields) if is_of_interest else {}

    @cached_property
    def _bindings(self) -> dict[int, Bindings]:
        return {}

    def bindings(self, function: FunctionNode) -> Bindings:
        """Return the variables that a function binds; computed once, as several checks ask for them."""
        if id(function) not in self._bindings:
            self._bindings[id(function)] = Bindings(function.body)
        return self._bindings[id(function)]

    @cached_property
    def signatures(self) -> Signatures:
        return Signatures(self.file, self.classes)


class Signatures:
    """Which messages the functions of a file are called with."""

    def __init__(self, file: PythonFile, classes: MessageClasses) -> None:
        self.classes = classes
        self.callbacks = callback_types(file, classes)
        self.handed = handed_objects(file)
        self.called = {last_name(node.func) for node in nodes_of_kind(file.tree, ast.Call)}

    def parameters(self, function: FunctionNode, owner: str) -> dict[str, str]:
        """Return the parameters that hold a message, by the registration as a callback, or by annotation.

        A registration takes precedence: rclpy passes its own objects, whatever an annotation says. Annotations count
        only where the file does not call the function, as a caller may pass other objects.
        """
        if function.name in self.handed:
            return {}
        every = [*function.args.posonlyargs, *function.args.args]
        types = self.callbacks.get((owner, function.name), ()) if not function.decorator_list else ()
        found = {each.arg: kind for each, kind in zip(every[bool(owner) :], types, strict=False)}
        for each in [*every, *function.args.kwonlyargs]:
            if each.annotation is not None and each.arg not in found:
                found[each.arg] = self.classes.message(each.annotation) if function.name not in self.called else ""
        return {name: kind for name, kind in found.items() if kind}


def local(variables: Environment) -> Environment:
    return {name: kind for name, kind in variables.items() if "." not in name}

"""The bodies of a file's functions, each with the variables that hold a message in it."""

from __future__ import annotations

import ast
from collections.abc import Iterator

from ...languages.python.file import PythonFile
from ...languages.python.nodes import nodes_of, nodes_of_kind
from .callback_types import callback_types
from .message_classes import MessageClasses
from .message_variables import Environment, Fields, FunctionNode, asked_names, attributes_of, variables_of


def bodies_with_variables(
    file: PythonFile, classes: MessageClasses, fields: Fields
) -> Iterator[tuple[list[ast.stmt], Environment]]:
    """Yield the file's own statements and those of each function, with the variables that hold a message there."""
    yield file.tree.body, variables_of(file.tree.body, {}, classes, fields)
    signatures = Signatures(file, classes)
    owned: set[int] = set()
    for owner in nodes_of_kind(file.tree, ast.ClassDef):
        methods = [each for each in owner.body if isinstance(each, FunctionNode)]
        owned |= {id(each) for each in methods}
        named: list[tuple[FunctionNode, Environment]] = [
            (each, variables_of(each.body, signatures.parameters(each, owner.name), classes, fields))
            for each in methods
        ]
        shared = attributes_of(owner, named, classes, fields)
        for each, variables in named:
            asked = set(asked_names(each.body)) if shared else ()
            attributes = {name: kind for name, kind in shared.items() if name not in asked}
            yield each.body, {**attributes, **local(variables)}
    for function in nodes_of(file.tree):
        if isinstance(function, FunctionNode) and id(function) not in owned:
            given = signatures.parameters(function, "")
            yield function.body, local(variables_of(function.body, given, classes, fields))


class Signatures:
    """Which messages the functions of a file are called with."""

    def __init__(self, file: PythonFile, classes: MessageClasses) -> None:
        self.classes = classes
        self.callbacks = callback_types(file, classes)
        self.called = {
            node.func.attr if isinstance(node.func, ast.Attribute) else getattr(node.func, "id", "")
            for node in nodes_of_kind(file.tree, ast.Call)
        }

    def parameters(self, function: FunctionNode, owner: str) -> dict[str, str]:
        """Return the parameters that hold a message: by what the function is registered for, or by annotation.

        Annotations count where the file does not call the function: a caller may pass what they don't say.
        """
        every = [*function.args.posonlyargs, *function.args.args]
        types = self.callbacks.get((owner, function.name), ()) if not function.decorator_list else ()
        found = {each.arg: kind for each, kind in zip(every[bool(owner) :], types, strict=False)}
        for each in [*every, *function.args.kwonlyargs]:
            if each.annotation is not None:
                found[each.arg] = self.classes.message(each.annotation) if function.name not in self.called else ""
        return {name: kind for name, kind in found.items() if kind}


def local(variables: Environment) -> Environment:
    return {name: kind for name, kind in variables.items() if "." not in name}

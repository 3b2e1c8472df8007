"""Whether a module gives itself names that its text does not bind."""

from __future__ import annotations

import ast

from .nodes import nodes_of_kind

TOUCHING = frozenset({"globals", "setattr", "exec", "vars", "__dict__"})


def has_dynamic_names(tree: ast.Module) -> bool:
    """Return whether code may set names of the module.

    What an object gets is none: `setattr(self, …)`, `vars(arguments)`, `self.__dict__`.
    """
    of_objects = {id(call.func) for call in nodes_of_kind(tree, ast.Call) if changes_an_object(call)}
    named = (node for node in nodes_of_kind(tree, ast.Name) if node.id in TOUCHING)
    dicts = (node for node in nodes_of_kind(tree, ast.Attribute) if node.attr == "__dict__")
    return any(id(node) not in of_objects for node in named) or any(not is_self(node.value) for node in dicts)


def changes_an_object(call: ast.Call) -> bool:
    """Return whether a call sets or reads the attributes of what is no module: `self`, one of its parts, a value."""
    match call:
        case ast.Call(func=ast.Name(id="setattr"), args=[target, *_]):
            return is_self(target) or isinstance(target, ast.Attribute)
        case ast.Call(func=ast.Name(id="vars"), args=[_]):
            return True
    return False


def is_self(node: ast.expr) -> bool:
    return isinstance(node, ast.Name) and node.id in ("self", "cls")

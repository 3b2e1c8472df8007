"""Whether a module gives itself names that its text does not bind."""

from __future__ import annotations

import ast
from collections.abc import Iterator

from .nodes import nodes_of_kind

TOUCHING = frozenset({"globals", "setattr", "exec", "vars"})
FINDING = frozenset({"modules", "import_module", "__import__", "getmodule"})
"""How code comes to a module by its name: `sys.modules`, `importlib.import_module`."""


def has_dynamic_names(tree: ast.Module) -> bool:
    """Return whether code may set names of the module.

    What an object gets is none: `setattr(message, …)`, `vars(arguments)`, `self.__dict__`. An object is a module only
    where it is imported, or where the code finds modules by their names.
    """
    called = [call.func for call in nodes_of_kind(tree, ast.Call) if call.args]
    of_objects = {id(each) for each in called if isinstance(each, ast.Name) and each.id in ("setattr", "vars")}
    if any(node.id in TOUCHING and id(node) not in of_objects for node in nodes_of_kind(tree, ast.Name)):
        return True
    changed = [*changed_objects(tree)]
    if not changed:
        return False
    imported = set(imported_names(tree))
    return finds_modules(tree) or any(isinstance(each, ast.Name) and each.id in imported for each in changed)


def changed_objects(tree: ast.Module) -> Iterator[ast.expr]:
    """Yield what is given attributes by `setattr` or its `__dict__`, but for `self`."""
    for call in nodes_of_kind(tree, ast.Call):
        match call:
            case ast.Call(func=ast.Name(id="setattr"), args=[target, *_]):
                if not is_self(target) and not isinstance(target, ast.Attribute):
                    yield target
    yield from (
        each.value for each in nodes_of_kind(tree, ast.Attribute) if each.attr == "__dict__" and not is_self(each.value)
    )


def finds_modules(tree: ast.Module) -> bool:
    names = {node.attr for node in nodes_of_kind(tree, ast.Attribute)}
    names |= {node.id for node in nodes_of_kind(tree, ast.Name)}
    return not names.isdisjoint(FINDING)


def imported_names(tree: ast.Module) -> Iterator[str]:
    yield from (each.asname or each.name.partition(".")[0] for each in nodes_of_kind(tree, ast.alias))


def is_self(node: ast.expr) -> bool:
    return isinstance(node, ast.Name) and node.id in ("self", "cls")

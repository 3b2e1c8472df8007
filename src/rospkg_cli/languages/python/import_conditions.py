"""Conditions and handlers around imports: which of them make an import optional."""

from __future__ import annotations

import ast

from .nodes import nodes_of

IMPORT_ERRORS = frozenset({"ImportError", "ModuleNotFoundError", "Exception", "BaseException"})
PLATFORM = frozenset({"sys", "os", "platform", "find_spec", "environ"})


def handles_import_error(handler: ast.ExceptHandler) -> bool:
    if handler.type is None:
        return True
    return any(isinstance(node, ast.Name) and node.id in IMPORT_ERRORS for node in nodes_of(handler.type))


def suppresses_import_error(manager: ast.expr) -> bool:
    """Return whether this is contextlib.suppress(ImportError)."""
    return (
        isinstance(manager, ast.Call) and {"suppress"} <= names_in(manager) and bool(names_in(manager) & IMPORT_ERRORS)
    )


def depends_on_platform(test: ast.expr) -> bool:
    """Return whether a condition depends on the platform or the environment: code under it is optional."""
    return bool(names_in(test) & PLATFORM)


def names_in(node: ast.expr) -> set[str]:
    """Return the names and attributes in an expression."""
    names = {each.id for each in nodes_of(node) if isinstance(each, ast.Name)}
    return names | {each.attr for each in nodes_of(node) if isinstance(each, ast.Attribute)}


def asked(test: ast.expr) -> frozenset[str]:
    """Return the strings that a condition asks for by a comparison or a call: `'cv2' in installed()`."""
    if not any(isinstance(node, ast.Compare | ast.Call) for node in nodes_of(test)):
        return frozenset()
    values = (node.value for node in nodes_of(test) if isinstance(node, ast.Constant))
    return frozenset(value for value in values if isinstance(value, str))


def is_type_checking(test: ast.expr) -> bool:
    return (isinstance(test, ast.Name) and test.id == "TYPE_CHECKING") or (
        isinstance(test, ast.Attribute) and test.attr == "TYPE_CHECKING"
    )

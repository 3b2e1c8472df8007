"""Whether a class passes its object to a library, which may set attributes of it."""

from __future__ import annotations

import ast
from collections.abc import Iterator

from ...languages.python.dynamic_names import is_self
from ...languages.python.file import PythonFile
from ...languages.python.nodes import nodes_of_kind
from ...ros.imports import STANDARD
from ...ros.names import BUILT_IN
from ..python.installed_modules import InstalledModules
from .own_classes import OwnClass

FILLING = frozenset({"setupUi", "setup_ui", "loadUi", "load_ui"})


def is_handed_out(owner: OwnClass, installed: InstalledModules) -> bool:
    """Return whether a class passes its object to a library that may fill it: `Machine(model=self)`, `setupUi`."""
    imported = dict(imported_from(owner.file))
    for call in nodes_of_kind(owner.node, ast.Call):
        if any(is_self(each) for each in (*call.args, *(keyword.value for keyword in call.keywords))):
            *_, root = chain(call.func)
            top = imported.get(root, "").partition(".")[0]
            is_known = top in STANDARD or top in installed.tops or BUILT_IN.is_package(top)
            if not (is_known or top == "") or chain(call.func)[0] in FILLING:
                return True
    return False


def imported_from(file: PythonFile) -> Iterator[tuple[str, str]]:
    """Yield the names that a file imports, with the modules that they are or come from."""
    for each in nodes_of_kind(file.tree, ast.Import):
        yield from ((alias.asname or alias.name.partition(".")[0], alias.name) for alias in each.names)
    for one in nodes_of_kind(file.tree, ast.ImportFrom):
        yield from ((alias.asname or alias.name, "" if one.level else one.module or "") for alias in one.names)


def chain(node: ast.expr) -> list[str]:
    """Return the names of an attribute, the last one first: `["spin", "rclpy"]`."""
    names = []
    while isinstance(node, ast.Attribute):
        names.append(node.attr)
        node = node.value
    return [*names, node.id if isinstance(node, ast.Name) else ""]

"""Which expressions of a Python file make actions of launch or plain values, by the names that it imports."""

from __future__ import annotations

import ast
from collections.abc import Mapping
from typing import cast

from ...languages.python.file import PythonFile
from ...languages.python.nodes import children_of, last_name, nodes_of_kind
from ...ros.launch_calls import ACTIONS

PARTS = ACTIONS | {"ComposableNode"}
PLAIN = ("Path", "path.join", "get_package_share_directory", "get_package_share_path", "get_package_prefix")
"""Calls that make paths, by how their names end."""


def is_action(value: ast.expr, file: PythonFile) -> bool:
    """Return whether a value is certainly an action of launch: a call of a class that is imported from there."""
    if not isinstance(value, ast.Call):
        return False
    known = from_launch(file)
    if isinstance(value.func, ast.Name):
        return known.get(value.func.id) in PARTS
    return last_name(value.func) in PARTS and root_of(value.func) in known


def root_of(function: ast.expr) -> str:
    """Return the name that a function is reached from: `a` of `a.b.c`; "" for any other expression."""
    while isinstance(function, ast.Attribute):
        function = function.value
    return function.id if isinstance(function, ast.Name) else ""


def from_launch(file: PythonFile) -> Mapping[str, str]:
    """Return the names that imports of the packages of launch bind, with what these call them."""
    known = vars(file)
    if "from_launch" not in known:
        found: dict[str, str] = {}
        imports: list[ast.Import | ast.ImportFrom] = [*nodes_of_kind(file.tree, ast.Import)]
        for each in (*imports, *nodes_of_kind(file.tree, ast.ImportFrom)):
            for alias in each.names:
                origin = alias.name if isinstance(each, ast.Import) else each.module or ""
                if not origin.startswith("launch") or (isinstance(each, ast.ImportFrom) and each.level):
                    found.pop(alias.asname or alias.name, "")
                elif alias.name == "*":
                    found.update({name: name for name in PARTS - found.keys()})
                else:
                    plain = alias.name.partition(".")[0] if isinstance(each, ast.Import) else alias.name
                    found[alias.asname or plain] = alias.name
        own = {*file.functions, *(each.name for each in nodes_of_kind(file.tree, ast.ClassDef))}
        known["from_launch"] = {name: what for name, what in found.items() if name not in own}
    return cast("Mapping[str, str]", known["from_launch"])


def is_plain(value: ast.expr, file: PythonFile) -> bool:
    """Return whether a value is made of constants, what launch makes, and paths of files."""
    waiting: list[ast.AST] = [value]
    while waiting:
        each = waiting.pop()
        if not isinstance(each, ast.Call):
            waiting += children_of(each)
        elif root_of(each.func) not in from_launch(file) and not ast.unparse(each.func).endswith(PLAIN):
            return False
    return True

"""Whether a base of a class is a node of rclpy: by where the file takes the name from, not by the name."""

from __future__ import annotations

import ast

from ...languages.python.file import PythonFile
from ...languages.python.imports import Import

NODES = {"rclpy.node": frozenset({"Node"}), "rclpy.lifecycle": frozenset({"Node", "LifecycleNode"})}


def is_of_rclpy(file: PythonFile, base: ast.expr) -> bool:
    """Return whether a base is a node of rclpy, whatever the file calls it, and nothing else by another import."""
    module, _, name = ast.unparse(base).rpartition(".")
    if name in NODES.get(module, ()):
        return True
    found = [] if is_own_class(file, module or name) else origins(file, module or name)
    homes = [(f"{each.module}.{own}", name) if module else (each.module, own) for each, own in found if not each.level]
    return bool(found) and len(homes) == len(found) and all(own in NODES.get(home, ()) for home, own in homes)


def origins(file: PythonFile, name: str) -> list[tuple[Import, str]]:
    """Return the imports that bind a name in a file, each with what it is called where it comes from."""
    every = ((each, *both) for each in file.imports for both in zip(each.names, each.bound, strict=False))
    return [(each, own) for each, own, bound in every if bound == name]


def is_own_class(file: PythonFile, name: str) -> bool:
    """Return whether a file has a class of a name at its top level, which takes the place of an import."""
    return any(isinstance(each, ast.ClassDef) and each.name == name for each in file.tree.body)

"""Which classes of a package share members by `self`: those that inherit from one another, at whatever distance."""

from __future__ import annotations

import ast
from collections.abc import Iterable

from ...languages.python.file import PythonFile
from ...languages.python.nodes import nodes_of_kind
from .named_definitions import EMPTY, OF_NODES

SHARED = OF_NODES | EMPTY | {"Thread", "QWidget"}
"""Bases of many classes that call none of the members which these have by their own names."""


def class_families(files: Iterable[PythonFile]) -> dict[str, str]:
    """Return each name of a class with one that stands for its family; classes of one name count as one."""
    head: dict[str, str] = {}

    def first(name: str) -> str:
        while head.setdefault(name, name) != name:
            name = head[name]
        return name

    for file in files:
        for owner in nodes_of_kind(file.tree, ast.ClassDef):
            first(owner.name)
            for base in owner.bases:
                name = ast.unparse(base).partition("[")[0].rpartition(".")[2]
                if name not in SHARED:
                    head[first(owner.name)] = first(name)
    return {name: first(name) for name in head}

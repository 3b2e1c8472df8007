"""Launch actions for nodes in Python code outside of launch files: `Node(package='…', executable='…')`."""

from __future__ import annotations

import ast
from collections.abc import Iterator

from ...languages.python.file import PythonFile
from ...languages.python.nodes import last_name, nodes_of_kind
from ...light_dataclasses import dataclass
from ...source import Span

CLASSES = frozenset({"Node", "LifecycleNode", "ComposableNode", "ComposableNodeContainer"})
WHAT = frozenset({"executable", "plugin"})
OBJECT = "Package"
"""The class of objects that generators of launch files have for the name of a package."""


@dataclass(frozen=True, slots=True)
class DescribedNode:
    """The package that a call names for certain, and where."""

    package: str
    span: Span


def described_nodes(file: PythonFile) -> Iterator[DescribedNode]:
    """Yield the nodes whose package is known, and which have an executable or a plugin, in the order of the text.

    So are launch files of `package=Package('…')`, an object for the name. A name that is assigned once stands for it.
    """
    if "package=" not in file.source.text:
        return
    values, classes = assigned_once(file), CLASSES | renamed(file)
    for node in nodes_of_kind(file.tree, ast.Call):
        given = next((each.value for each in node.keywords if each.arg == "package"), None)
        value = values.get(ast.unparse(given)) or given if isinstance(given, ast.Name | ast.Attribute) else given
        is_node = last_name(node.func) in classes and bool(WHAT & {each.arg for each in node.keywords})
        if isinstance(value, ast.Call) and last_name(value.func) == OBJECT and len(value.args) == 1:
            value, is_node = value.args[0], True
        if is_node and isinstance(value, ast.Constant) and isinstance(value.value, str):
            yield DescribedNode(value.value, file.span(value))


def renamed(file: PythonFile) -> frozenset[str]:
    """Return the names that imports give to classes: `Node as LaunchNode`."""
    every = (alias for node in nodes_of_kind(file.tree, ast.ImportFrom) for alias in node.names)
    return frozenset(alias.asname for alias in every if alias.asname and alias.name in CLASSES)


def assigned_once(file: PythonFile) -> dict[str, ast.expr]:
    """Return the values of names and attributes (`self.package`) that a file assigns in one place."""
    found: dict[str, list[ast.expr]] = {}
    for node in nodes_of_kind(file.tree, ast.Assign):
        for target in node.targets:
            if isinstance(target, ast.Name | ast.Attribute):
                found.setdefault(ast.unparse(target), []).append(node.value)
    return {name: values[0] for name, values in found.items() if len(values) == 1}

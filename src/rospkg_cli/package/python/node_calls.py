"""Launch actions for nodes in Python code outside of launch files: `Node(package='…', executable='…')`."""

from __future__ import annotations

import ast
from collections.abc import Iterator

from ...languages.python.file import PythonFile
from ...languages.python.nodes import nodes_of_kind
from ...light_dataclasses import dataclass
from ...source import Span

CLASSES = frozenset({"Node", "LifecycleNode", "ComposableNode", "ComposableNodeContainer"})
WHAT = frozenset({"executable", "plugin"})


@dataclass(frozen=True, slots=True)
class DescribedNode:
    """The package that a call names for certain, and where."""

    package: str
    span: Span


def described_nodes(file: PythonFile) -> Iterator[DescribedNode]:
    """Yield the nodes whose package and executable (or plugin) are literals in the call, in the order of the text."""
    if "package=" not in file.source.text:
        return
    for node in nodes_of_kind(file.tree, ast.Call):
        if called(node.func) in CLASSES:
            arguments = {keyword.arg: keyword.value for keyword in node.keywords}
            package = arguments.get("package")
            literal = isinstance(package, ast.Constant) and isinstance(package.value, str)
            if isinstance(package, ast.Constant) and literal and WHAT & arguments.keys():
                yield DescribedNode(str(package.value), file.span(package))


def called(function: ast.expr) -> str:
    """Return the last part of the name of what is called."""
    match function:
        case ast.Name(id=name) | ast.Attribute(attr=name):
            return name
    return ""

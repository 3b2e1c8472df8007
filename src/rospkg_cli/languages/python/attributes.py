"""The names of attributes: where they stand, and which are of the object itself."""

from __future__ import annotations

import ast
from typing import TypeGuard

from ...source import Span
from .file import PythonFile


def is_of_self(node: ast.AST) -> TypeGuard[ast.Attribute]:
    """Return whether this is `self.name`, which names a member of the class around it or of its family alone."""
    return isinstance(node, ast.Attribute) and isinstance(node.value, ast.Name) and node.value.id == "self"


def attribute_span(file: PythonFile, node: ast.Attribute) -> Span:
    """Return the place of the name alone: `spin` of `rclpy.spin`."""
    end = file.span(node).end
    return Span(end - len(node.attr), end)

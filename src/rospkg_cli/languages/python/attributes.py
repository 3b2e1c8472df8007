"""Where the name of an attribute stands."""

from __future__ import annotations

import ast

from ...source import Span
from .file import PythonFile


def attribute_span(file: PythonFile, node: ast.Attribute) -> Span:
    """Return the place of the name alone: `spin` of `rclpy.spin`."""
    end = file.span(node).end
    return Span(end - len(node.attr), end)

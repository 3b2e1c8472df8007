"""Places in Python code that no run on Linux comes to."""

from __future__ import annotations

from ...source import Span
from .constant_truth import unreached_statements
from .file import PythonFile
from .nodes import nodes_of


def is_unreached(file: PythonFile, span: Span) -> bool:
    """Return whether a place is behind a `raise`, or under `if False` or what never holds on Linux.

    What a switch turns off may be turned on.
    """
    return any(file.span(each).holds(span) for each in unreached_statements(nodes_of(file.tree), {}))

"""Places in Python code that no run on Linux comes to."""

from __future__ import annotations

from typing import cast

from ...source import Span
from .constant_truth import unreached_statements
from .file import PythonFile
from .nodes import nodes_of


def is_unreached(file: PythonFile, span: Span) -> bool:
    """Return whether a place is behind a `raise`, or under `if False` or what never holds on Linux.

    What a switch turns off may be turned on.
    """
    return any(each.holds(span) for each in unreached_spans(file))


def unreached_spans(file: PythonFile) -> tuple[Span, ...]:
    """Return the spans of the outer statements that no run comes to; kept with the file, as many places are asked."""
    known = vars(file)
    if "unreached_spans" not in known:
        known["unreached_spans"] = tuple(map(file.span, unreached_statements(nodes_of(file.tree), {})))
    return cast("tuple[Span, ...]", known["unreached_spans"])

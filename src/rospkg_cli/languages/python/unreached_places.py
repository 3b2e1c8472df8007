"""Places in Python code that no run on Linux comes to."""

from __future__ import annotations

from typing import cast

from ...source import Span
from .constant_truth import unreached_statements
from .file import PythonFile
from .nodes import nodes_of
from .unread_types import for_type_checkers, unread_types


def is_unreached(file: PythonFile, span: Span) -> bool:
    """Return whether a place is behind a `raise`, under `if False` or what never holds on Linux, or an unread type.

    What a switch turns off may be turned on.
    """
    return any(each.holds(span) for each in unreached_spans(file))


def unreached_spans(file: PythonFile) -> tuple[Span, ...]:
    """Return the spans of the outer parts that no run comes to; kept with the file, as many places are asked."""
    known = vars(file)
    if "unreached_spans" not in known:
        statements = map(file.span, (*unreached_statements(nodes_of(file.tree), {}), *for_type_checkers(file)))
        known["unreached_spans"] = (*statements, *map(file.span, unread_types(file)))
    return cast("tuple[Span, ...]", known["unreached_spans"])

"""Whether Python runs a line of a launch file before launch has the description that the file returns."""

from __future__ import annotations

import ast

from ...languages.python.branches import is_under_condition
from ...languages.python.file import PythonFile
from ...languages.python.nodes import functions_of, nodes_of_kind
from ...package.launch.launch_evaluator import ENTRIES
from ...source import Span


def ends_description(file: PythonFile, span: Span) -> bool:
    """Return whether each call of the function that launch calls reaches a place, or the import of the file does.

    Functions that this one calls, or hands to launch, may be left before it; so may a `try`.
    """
    around = [each for each in functions_of(file.tree) if file.span(each).holds(span)]
    is_later = any(file.span(each).holds(span) for each in nodes_of_kind(file.tree, ast.Lambda))
    is_own = not around or (len(around) == 1 and around[0] in file.tree.body and around[0].name in ENTRIES)
    is_tried = any(file.span(each).holds(span) for each in nodes_of_kind(file.tree, ast.Try))
    return is_own and not is_later and not is_tried and not is_under_condition(file, span)

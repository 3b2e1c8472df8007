"""The place of a text in a Python file, where it is written as one plain literal."""

from __future__ import annotations

import ast
import re

from ..languages.python.file import PythonFile
from ..lazy_regex import regex
from ..source import Span

LITERAL = regex(r"""[rRuU]?("{3}|'{3}|"|')(.*)\1""", re.DOTALL)


def literal_span(file: PythonFile, node: ast.Constant) -> Span | None:
    """Return the span between the quotes; None where escapes or several literals make the text."""
    whole = file.span(node)
    match = LITERAL.fullmatch(file.source.text, whole.start, whole.end)
    return Span(*match.span(2)) if match and match[2] == node.value else None

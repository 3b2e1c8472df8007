"""Names that a comment next to them says are still to be written, as in exercises (DEP117)."""

from __future__ import annotations

import ast
from collections.abc import Iterable

from ...languages.python.file import PythonFile
from ...source import Span
from .undefined_uses import UndefinedUse

LOUD = ("certainly", "maybe")
UNWRITTEN = "; a comment says that it is still to be written"
BLANK = "; the name is a blank that is to be filled in"


def why_unwritten(use: UndefinedUse) -> str:
    """Return what is said of a name that is left to be written; "" for any other."""
    if use.when not in LOUD:
        return ""
    return why_open(use.file, use.found.name, use.found.span)


def why_open(file: PythonFile, name: str, span: Span) -> str:
    """Return what is said of a use of a name that is a blank, or that a comment asks for; "" for any other."""
    from ..python.blank_names import is_blank  # what few files need
    from ..python.left_blank import announces, is_asked_for

    text = file.source.text
    if is_blank(name):
        return BLANK
    return UNWRITTEN if announces(text, span.start, name) or is_asked_for(text, name) else ""


def is_member_unwritten(file: PythonFile, owner: ast.ClassDef, name: str, places: Iterable[Span]) -> bool:
    """Return whether a comment where a member is read, or in the constructor, says that it is still to be written."""
    from ..python.left_blank import announces, is_asked_for

    text = file.source.text
    if is_asked_for(text, name):
        return True
    starts = (each for each in owner.body if isinstance(each, ast.FunctionDef) and each.name == "__init__")
    is_read_so = any(announces(text, each.start, name) for each in places)
    return is_read_so or any(announces(text, file.span(each.body[0]).start, name, behind=True) for each in starts)

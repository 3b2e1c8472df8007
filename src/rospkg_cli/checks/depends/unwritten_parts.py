"""Names that a comment beside them says are still to be written, as in exercises (DEP117)."""

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
    from ..left_blank import announces, is_blank  # what few files need

    text, name = use.file.source.text, use.found.name
    return BLANK if is_blank(name) else UNWRITTEN if announces(text, use.found.span.start, name) else ""


def is_member_unwritten(file: PythonFile, owner: ast.ClassDef, name: str, places: Iterable[Span]) -> bool:
    """Return whether a comment where a member is read, or in the constructor, says that it is still to be written."""
    from ..left_blank import announces

    text = file.source.text
    starts = (each for each in owner.body if isinstance(each, ast.FunctionDef) and each.name == "__init__")
    is_read_so = any(announces(text, each.start, name) for each in places)
    return is_read_so or any(announces(text, file.span(each.body[0]).start, name, behind=True) for each in starts)

"""What a module of Python lacks at its top level, and leaves to whoever takes an exercise on."""

from __future__ import annotations

import ast

from ...languages.python.file import PythonFile

TO_WRITE = "; a comment there says that it is still to be written"


def why_left_to_write(file: PythonFile, name: str) -> str:
    """Return what is said of a function or class that a comment asks for, as the whole module may be; "" for others."""
    from .left_blank import asks_at_the_top, has_task, is_asked, is_asked_for  # what few files need

    text = file.source.text
    is_idle = not any(map(does, file.tree.body))
    is_blank = is_idle and (has_task(text) or is_asked(ast.get_docstring(file.tree) or ""))
    return TO_WRITE if is_blank or asks_at_the_top(text) or is_asked_for(text, name) else ""


def does(statement: ast.stmt) -> bool:
    """Return whether a statement is more than an import, a text, a constant or `pass`."""
    if isinstance(statement, (ast.Expr, ast.Assign, ast.AnnAssign)):
        return not isinstance(statement.value, ast.Constant)
    return not isinstance(statement, (ast.Import, ast.ImportFrom, ast.Pass))

"""Whether a module of Python is a script: it works when it is started by its path, or as it is imported."""

from __future__ import annotations

import ast
from collections.abc import Iterable, Iterator

from ...languages.python.file import PythonFile

FUNCTIONS = (ast.FunctionDef, ast.AsyncFunctionDef, ast.ClassDef)
BLOCKS = (ast.If, ast.Try, ast.With)
WORK = (ast.For, ast.While)
"""A call alone may register or configure something, for those who import the module."""


def is_run_by_path(file: PythonFile) -> bool:
    """Return whether a module does something of its own when Python is given its path."""
    return "__main__" in file.source.text or is_plain_script(file)


def is_plain_script(file: PythonFile) -> bool:
    """Return whether a module works in a loop as it is imported, and defines nothing that others may import of it."""
    if file.path.endswith("__init__.py"):
        return False
    statements = list(outer(file.tree.body))
    return any(isinstance(each, WORK) for each in statements) and not any(
        isinstance(each, FUNCTIONS) for each in statements
    )


def outer(body: Iterable[ast.stmt]) -> Iterator[ast.stmt]:
    """Yield the statements that run when a module is imported, and those in their branches."""
    for each in body:
        yield each
        if isinstance(each, BLOCKS):
            yield from outer(each.body)
            yield from outer(each.orelse if isinstance(each, ast.If | ast.Try) else ())

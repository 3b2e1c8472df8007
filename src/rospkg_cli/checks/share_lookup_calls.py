"""Calls in Python that look up the share directory or the prefix of a package."""

from __future__ import annotations

import ast
from collections.abc import Iterator

from ..languages.python.file import PythonFile
from ..package.file_role import role_of
from ..package.python.share_paths import SHARE
from .python.run_imports import RunImports
from .python.wrong_calls import wrong_lookup

LOOKUPS = SHARE | {"get_package_prefix"}
CATCHES = frozenset({"PackageNotFoundError", "KeyError", "LookupError", "Exception", "BaseException"})
"""PackageNotFoundError is a KeyError."""

UNOPENED = frozenset({"OSError", "IOError", "EnvironmentError", "Exception", "BaseException"})
"""What code catches around an open that may fail. Code that names FileNotFoundError expects it (see LOOKS_FIRST)."""


def looking_up(run: RunImports) -> Iterator[PythonFile]:
    """Yield the files that run and have such calls, but for launch files, which have rules of their own."""
    for file in run.running:
        if role_of(file.path) != "launch" and any(name in file.source.text for name in LOOKUPS):
            yield file


def literal_of(call: ast.Call) -> ast.Constant | None:
    """Return the package's name where a lookup is given a plain string, and not more than it takes."""
    if wrong_lookup(call):
        return None
    given = call.args[0] if call.args else next((each.value for each in call.keywords), None)
    plain = isinstance(given, ast.Constant) and isinstance(given.value, str) and given.value.isidentifier()
    return given if plain and isinstance(given, ast.Constant) else None

"""Python files in launch folders that are no launch files: modules that others import, and programs (LCH001)."""

from __future__ import annotations

import ast
import posixpath
import re
from collections.abc import Iterable

from ...files import PackageFiles
from ...languages.python.file import PythonFile
from ...package.launch.live_text import live_text
from ...ros.imports import STANDARD

OF_LAUNCH = "launch"
"""What the names of the packages begin with that describe launches."""


def is_imported(path: str, files: PackageFiles) -> bool:
    """Return whether another Python file of the package imports one as a module, or loads it by its path."""
    name = posixpath.basename(path)
    stem = re.escape(name.removesuffix(".py"))
    word = re.compile(
        rf"(?m)^\s*(?:from\s+[\w.]*(?<!\w){stem}\s+import\b|import\s+[\w., ]*(?<!\w){stem}(?!\w)"
        rf"|from\s+[\w.]+\s+import\b[^\n]*(?<!\w){stem}(?!\w))|(?:import_module|spec_from_file_location|run_path)\("
        rf"[^\n]*(?<!\w){stem}(?!\w)"
    )
    others = (each for each in files.paths if each.endswith(".py") and each != path)
    return any(word.search(files.readable_text(each)) and word.search(live_text(files, each)) for each in others)


def makes_its_own(file: PythonFile) -> bool:
    """Return whether a file may get its entry point by a decorator of another package, or launches by itself."""
    launches = any(isinstance(each, ast.Name) and each.id == "LaunchService" for each in ast.walk(file.tree))
    foreign = set(names_of(each for each in file.tree.body if isinstance(each, (ast.Import, ast.ImportFrom))))
    functions = (each for each in file.tree.body if isinstance(each, (ast.FunctionDef, ast.AsyncFunctionDef)))
    return launches or any(first_name(each) in foreign for function in functions for each in function.decorator_list)


def names_of(imports: Iterable[ast.Import | ast.ImportFrom]) -> Iterable[str]:
    """Yield the names that imports of other packages than Python's own bind."""
    for each in imports:
        for alias in each.names:
            module = alias.name if isinstance(each, ast.Import) else each.module or ""
            if module.partition(".")[0] not in STANDARD or (isinstance(each, ast.ImportFrom) and each.level):
                yield alias.asname or alias.name.partition(".")[0]


def first_name(node: ast.expr) -> str:
    """Return the name that a decorator begins with: `a` of `@a.b(c)`; "" for any other."""
    while isinstance(node, (ast.Call, ast.Attribute)):
        node = node.func if isinstance(node, ast.Call) else node.value
    return node.id if isinstance(node, ast.Name) else ""


def describes_nothing(file: PythonFile) -> bool:
    """Return whether a file has no statement, or imports nothing that describes launches."""
    return not any(each.module.startswith(OF_LAUNCH) for each in file.imports)

"""Modules that a Python file imports and calls like a function: `import glob`, and then `glob('*.py')`."""

from __future__ import annotations

import ast
from collections.abc import Iterator

from ...light_dataclasses import dataclass
from ...source import Span
from .file import PythonFile
from .nodes import nodes_of_kind

NAMESAKES = frozenset({"copy", "glob", "pprint", "time"})
"""Modules with a function of their name."""
MODULES = NAMESAKES | {"codecs", "fnmatch", "json", "os", "pathlib", "re", "setuptools", "shutil", "subprocess", "sys"}
"""Modules of which it is known that nothing can call them."""


@dataclass(frozen=True, slots=True)
class CalledModule:
    name: str
    span: Span
    """Of the name that is called."""
    function: str
    """The function of its name, as `glob.glob`; "" where the module has none."""


def called_modules(file: PythonFile) -> Iterator[CalledModule]:
    """Yield the calls of modules, where nothing else in the file binds their names."""
    imported = {alias.asname or alias.name: alias.name for each in nodes_of_kind(file.tree, ast.Import)
                for alias in each.names if alias.name in MODULES}  # fmt: skip
    for other in nodes_of_kind(file.tree, ast.ImportFrom):
        for alias in other.names:
            imported.pop(alias.asname or alias.name, None)
    for call in nodes_of_kind(file.tree, ast.Call) if imported and not file.star_imports else ():
        if isinstance(call.func, ast.Name) and call.func.id in imported and not is_bound(file, call.func.id):
            name = call.func.id
            function = f"{name}.{name}" if name == imported[name] in NAMESAKES else ""
            yield CalledModule(name, file.span(call.func), function)


def is_bound(file: PythonFile, name: str) -> bool:
    """Return whether something but an import gives a name a value: an assignment, a definition, a parameter."""
    stores = (node for node in nodes_of_kind(file.tree, ast.Name) if not isinstance(node.ctx, ast.Load))
    if any(node.id == name for node in stores) or any(node.arg == name for node in nodes_of_kind(file.tree, ast.arg)):
        return True
    if name not in file.definitions:
        return False
    functions = {each.name for each in nodes_of_kind(file.tree, ast.FunctionDef)}
    functions |= {each.name for each in nodes_of_kind(file.tree, ast.AsyncFunctionDef)}
    return name in functions or any(each.name == name for each in nodes_of_kind(file.tree, ast.ClassDef))

"""What a name of a Python file means among the package's own functions, classes and modules."""

from __future__ import annotations

import ast
import posixpath
from collections.abc import Mapping
from functools import cached_property

from ...languages.python.bindings import bindings
from ...languages.python.file import PythonFile
from ...languages.python.imports import Import
from ...languages.python.nodes import FunctionNode, nodes_of_kind
from ...light_dataclasses import dataclass
from ...source import Span
from ..python.installed_modules import InstalledModules
from ..python.run_imports import RunImports

DEPTH = 6


@dataclass(frozen=True, slots=True)
class Own:
    """A function, a class or a module of the package."""

    file: PythonFile
    node: FunctionNode | ast.ClassDef | ast.Module

    @property
    def key(self) -> int:
        return id(self.node)


@dataclass(frozen=True)
class Meanings:
    run: RunImports
    installed: InstalledModules

    @cached_property
    def known(self) -> dict[str, dict[str, Own]]:
        return {}

    def in_file(self, file: PythonFile, depth: int = 0) -> Mapping[str, Own]:
        """Return what the names of a file mean: `a.b` of an import, too."""
        if file.path not in self.known:
            found: dict[str, Own] = {}
            self.known[file.path] = found  # a circle of imports meets what is known so far
            for node in nodes_of_kind(file.tree, ast.ImportFrom):
                found |= self.imported_from(file, node, depth)
            for each in nodes_of_kind(file.tree, ast.Import):
                for alias in each.names:
                    module = self.module(file, alias.name, 0)
                    found |= {alias.asname or alias.name: module} if module is not None else {}
            for name, bound in bindings(file.tree.body, has_globals=False):
                if isinstance(bound, FunctionNode | ast.ClassDef):
                    found[name] = Own(file, bound)
        return self.known[file.path]

    def imported_from(self, file: PythonFile, node: ast.ImportFrom, depth: int) -> dict[str, Own]:
        module, found = self.module(file, node.module or "", node.level), dict[str, Own]()
        inner = self.in_file(module.file, depth + 1) if module is not None and depth < DEPTH else {}
        for alias in node.names:
            if alias.name == "*":
                found |= inner
                continue
            below = f"{node.module}.{alias.name}" if node.module else alias.name
            definition = inner.get(alias.name) or self.module(file, below, node.level)
            found |= {alias.asname or alias.name: definition} if definition is not None else {}
        return found

    def module(self, file: PythonFile, name: str, level: int) -> Own | None:
        """Return the module of the package that an import loads: an installed one, or one in the folder of the file."""
        full = self.installed.absolute(Import(name, (), level, Span(0, 0)), file.path)
        folder, below = posixpath.dirname(file.path), name.replace(".", "/")
        for path in (self.installed.sources.get(full, ""), posixpath.join(folder, f"{below}.py") if name else ""):
            found = self.run.modules.at(path) if path else None
            if found is not None:
                return Own(found, found.tree)
        return None

    def of(self, file: PythonFile, expression: ast.expr) -> Own | None:
        """Return what `name` or `module.name` means."""
        match expression:
            case ast.Name(id=name):
                return self.in_file(file).get(name)
            case ast.Attribute(value=value, attr=name):
                dotted = self.in_file(file).get(ast.unparse(expression)) if is_dotted(value) else None
                around = self.of(file, value) if dotted is None else None
                if around is not None and isinstance(around.node, ast.Module):
                    return self.in_file(around.file).get(name)
                return dotted
        return None


def is_dotted(node: ast.expr) -> bool:
    while isinstance(node, ast.Attribute):
        node = node.value
    return isinstance(node, ast.Name)

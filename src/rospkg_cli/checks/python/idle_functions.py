"""Rule input: functions of a package that nothing in it calls."""

from __future__ import annotations

import ast

from ...languages.python.file import PythonFile
from ...languages.python.nodes import nodes_of_kind
from ...languages.python.unreached_functions import unreached_functions
from ...light_dataclasses import dataclass
from ...package.install_table import InstallTable
from ...source import Span
from .run_imports import RunImports


@dataclass(frozen=True)
class IdleFunctions:
    run: RunImports
    table: InstallTable

    def has(self, file: PythonFile, span: Span) -> bool:
        """Return whether a place is in a function that its file never calls and no other file imports or reads."""
        taken = {name for _, other in self.run.files for each in other.imports for name in each.names}
        names = {row.entry.partition(":")[2] for row in self.table.of("executable")}
        for each in unreached_functions(file, names | taken):
            around = file.span(each)
            if around.holds(span) and not self.is_read_elsewhere(file, each.name):
                return True
        return False

    def is_read_elsewhere(self, file: PythonFile, name: str) -> bool:
        """Return whether another file has a name as an attribute: `module.name`."""
        return any(
            each.attr == name
            for _, other in self.run.files
            if other is not file
            for each in nodes_of_kind(other.tree, ast.Attribute)
        )

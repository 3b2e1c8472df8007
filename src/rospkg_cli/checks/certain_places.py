"""Rule input: what Python certainly runs whenever a program of the package starts, or a module of it is imported."""

from __future__ import annotations

import ast

from ..languages.python.certain_nodes import certain_nodes
from ..languages.python.file import PythonFile
from ..languages.python.nodes import nodes_of_kind
from ..light_dataclasses import dataclass
from ..package.install_table import InstallTable
from ..source import Span
from .python.installed_modules import InstalledModules
from .reached_modules import ReachedModules
from .unimported_modules import UnimportedModules
from .unwanted_modules import UnwantedModules


@dataclass(frozen=True)
class CertainPlaces:
    table: InstallTable
    installed: InstalledModules
    reached: ReachedModules
    unimported: UnimportedModules
    unwanted: UnwantedModules

    def spans(self, file: PythonFile) -> frozenset[Span]:
        """Return the spans of the names in a file that are read whenever it is started or imported.

        None in a module of a library that nothing in the workspace imports, as no program here fails there.
        """
        module, rows = self.installed.names.get(file.path, ""), [*self.table.of("executable")]
        is_program = any(row.source == file.path and not row.entry for row in rows)
        is_started = (is_program or module in self.reached.started) and not self.reached.is_left(file.path)
        is_met = is_started and not self.unimported.is_unimported(file.path)
        if not is_met or self.reached.is_optional(file.path) or self.unwanted.has(file):
            return frozenset()
        entries = [row.entry.partition(":")[2] for row in rows if row.entry.partition(":")[0] == module]
        nodes = certain_nodes(file, entries, is_program=is_program)
        return frozenset(file.span(each) for each in nodes_of_kind(file.tree, ast.Name) if id(each) in nodes)

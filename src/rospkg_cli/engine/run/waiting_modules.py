"""Where the runs of a package's modules wait for good, in constructors of nodes and at the calls of these."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from functools import cached_property

from ...checks.python.endless_waits import endless_waits
from ...checks.python.installed_modules import InstalledModules
from ...languages.python.file import PythonFile
from ...languages.python.imports import module_span
from ...languages.python.nodes import nodes_of_kind
from ...light_dataclasses import dataclass
from ...source import Span


@dataclass(frozen=True)
class WaitingModules:
    installed: InstalledModules

    def in_file(self, file: PythonFile) -> Iterator[Span]:
        """Yield the loops of a file that nothing ends, and its calls of imported classes that stay in such a one."""
        yield from (file.span(loop) for _, loop in endless_waits(file))
        for each in nodes_of_kind(file.tree, ast.ImportFrom):
            module = self.home(file, each)
            names = {alias.asname or alias.name for alias in each.names if (module, alias.name) in self.classes}
            for call in nodes_of_kind(file.tree, ast.Call) if names else ():
                if isinstance(call.func, ast.Name) and call.func.id in names:
                    yield file.span(call)

    def home(self, file: PythonFile, node: ast.ImportFrom) -> str:
        """Return the file that a module is imported from; "" for one of others."""
        span = module_span(file, node)
        found = next((each for each in file.imports if each.names and each.span == span), None)
        module = self.installed.absolute(found, file.path) if found is not None else node.module or ""
        return self.installed.sources.get(module, "")

    @cached_property
    def classes(self) -> frozenset[tuple[str, str]]:
        """The classes whose constructor never returns, with their files."""
        files = (file for path in self.installed.names if (file := self.installed.modules.at(path)) is not None)
        return frozenset((file.path, owner.name) for file in files for owner, _ in endless_waits(file))

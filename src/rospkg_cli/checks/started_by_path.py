"""Rule input: the modules of a package that are never started by their path, and their `__main__` blocks."""

from __future__ import annotations

import ast
from functools import cached_property

from ..languages.python.certain_nodes import is_guard
from ..languages.python.file import PythonFile
from ..languages.python.nodes import nodes_of
from ..lazy_regex import regex
from ..light_dataclasses import dataclass
from ..package.install_table import InstallTable
from .python.installed_modules import InstalledModules

NAMING = (".py", ".md", ".rst", ".sh", ".txt", ".cfg", ".toml", ".xml", ".launch", ".yaml", ".yml")
"""Files that may start a module by its path, or say how to."""
FILE = regex(r"[\w.-]+\.py(?!\w)")


@dataclass(frozen=True)
class StartedByPath:
    table: InstallTable
    installed: InstalledModules

    def in_vain(self, file: PythonFile) -> frozenset[int]:
        """Return the identities of the nodes under `if __name__ == '__main__'` of a module that is only imported."""
        if file.path not in self.imported_alone:
            return frozenset()
        guards = (each for each in file.tree.body if isinstance(each, ast.If) and is_guard(each))
        return frozenset(id(node) for each in guards for part in each.body for node in nodes_of(part))

    @cached_property
    def imported_alone(self) -> frozenset[str]:
        """The modules of a package with programs whose files are no programs, and are named in no text."""
        rows = [*self.table.of("executable")]
        modules = set(self.installed.names) if rows else set[str]()
        modules -= {row.source for row in rows if not row.entry}
        pages = (path for path in self.installed.files.paths if modules and path.endswith(NAMING))
        texts = map(self.installed.files.readable_text, pages)
        named = {name for text in texts for name in python_files_in(text)}
        return frozenset(path for path in modules if path.rpartition("/")[2] not in named)

    @cached_property
    def entries(self) -> frozenset[tuple[str, str]]:
        """The functions that entry points call, with their files; "" where the file is not known."""
        entries = [row.entry.partition(":") for row in self.table.of("executable")]
        sources = self.installed.sources
        return frozenset((sources.get(module, ""), name.partition(".")[0]) for module, _, name in entries)


def python_files_in(text: str) -> list[str]:
    """Return the names of Python files that a text has; a plain search goes first, as a `.txt` may be all numbers."""
    return FILE.findall(text) if ".py" in text else []

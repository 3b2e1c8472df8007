"""Which of a package's own modules are imported when what it starts, launches or tests is run."""

from __future__ import annotations

import re
from functools import cached_property

from ...languages.python.file import Import
from ...light_dataclasses import dataclass
from ...package.install_table import InstallTable
from ..run_imports import RunImports
from .installed_modules import InstalledModules

NAMING = (".py", ".cfg", ".toml", ".xml", ".yaml", ".yml", ".urdf", ".xacro", ".txt", ".launch")
"""Files that name modules: entry points, plugins, launch files."""


@dataclass(frozen=True)
class ReachedModules:
    installed: InstalledModules
    run: RunImports
    table: InstallTable

    @cached_property
    def is_library(self) -> bool:
        """Whether the package has modules for others alone: it is known that it installs no program."""
        programs = any(self.table.of("executable"))
        return not programs and self.table.knows("executable") and self.table.knows("module")

    @cached_property
    def started(self) -> frozenset[str]:
        """The installed modules that entry points start, and those that these import.

        Of a library it is every module that does nothing when it is started by its path.
        """
        waiting = [row.entry.partition(":")[0] for row in self.table.of("executable") if row.entry]
        for module, source in self.installed.sources.items() if self.is_library else ():
            file = self.run.modules.at(source)
            waiting += [module] if file is not None and "__main__" not in file.source.text else []
        return self.imported_from(waiting)

    def has(self, path: str) -> bool:
        """Return whether a file is no installed module, or one that something else imports or names."""
        name = self.installed.names.get(path)
        return name is None or name in self.all

    @cached_property
    def all(self) -> frozenset[str]:
        """The installed modules that other files import or name, and those that these import.

        On its way to a module Python runs the `__init__.py` of each package that it is in.
        """
        names, programs = self.installed.names, {row.source for row in self.table.of("executable")}
        waiting = [name for name in self.installed.sources if "." not in name or self.is_named(name)]
        for file in self.run.running:
            if file.path not in names or file.path in programs:
                for each in file.imports:
                    waiting += self.imported_by(each, file.path)
        return self.imported_from(waiting, around=True)

    def is_named(self, module: str) -> bool:
        """Return whether a text of the package that is no installed module names one."""
        word, files = re.compile(rf"(?<![\w.]){re.escape(module)}(?!\w)"), self.installed.files
        paths = (path for path in files.paths if path.endswith(NAMING) and path not in self.installed.names)
        return any(word.search(files.readable_text(path)) for path in paths)

    def imported_by(self, each: Import, path: str) -> list[str]:
        inner = self.installed.absolute(each, path)
        return [inner, *(f"{inner}.{name}" for name in each.names)]

    def imported_from(self, waiting: list[str], *, around: bool = False) -> frozenset[str]:
        """Return some modules and those that they import; with the packages `around` them, where asked."""
        found: set[str] = set()
        while waiting:
            module = waiting.pop()
            source = self.installed.sources.get(module, "")
            file = self.run.modules.at(source) if source else None
            if module not in found and file is not None:
                found.add(module)
                waiting += [module.rpartition(".")[0]] if around and "." in module else []
                for each in file.imports:
                    waiting += self.imported_by(each, source)
        return frozenset(found)

"""Rule input: which of a package's own modules are imported when its programs, launch files or tests run."""

from __future__ import annotations

from functools import cached_property

from ..light_dataclasses import dataclass
from ..package.file_role import Role
from ..package.install_table import InstallTable
from .module_mentions import ModuleMentions
from .python.installed_modules import InstalledModules
from .python.module_imports import ModuleImports
from .python.plain_scripts import is_run_by_path
from .python.run_imports import RunImports


@dataclass(frozen=True)
class ReachedModules:
    installed: InstalledModules
    run: RunImports
    table: InstallTable
    imports: ModuleImports
    mentions: ModuleMentions

    @cached_property
    def is_library(self) -> bool:
        """Whether the package has modules for others alone: it is known that it installs no program."""
        programs = any(self.table.of("executable"))
        return not programs and self.table.knows("executable") and self.table.knows("module")

    @cached_property
    def started(self) -> frozenset[str]:
        """The installed modules that entry points start, and those that these import.

        In a library every module counts, but for scripts that are run by their path (see `is_run_by_path`) and the
        modules next to them that they import.
        """
        waiting = self.entries
        if self.is_library:
            files = {module: self.run.modules.at(source) for module, source in self.installed.sources.items()}
            programs = [module for module, file in files.items() if file and is_run_by_path(file)]
            of_scripts = self.imports.imported_from_folder(programs)
            waiting += [module for module, file in files.items() if file and module not in of_scripts]
        return self.imports.imported_from(waiting)

    def has(self, path: str) -> bool:
        """Return whether a file is no installed module, or one that something else imports or names."""
        name = self.installed.names.get(path)
        return name is None or name in self.all

    def is_left(self, path: str) -> bool:
        """Return whether a file is a module that nothing of the package starts, imports or names.

        In a library it is a script that is run by its path, or a module that only such scripts import. Where it is not
        known which programs the package installs, no module counts.
        """
        if path not in self._left:
            self._left[path] = self.is_named_nowhere(path)
        return self._left[path]

    @cached_property
    def _left(self) -> dict[str, bool]:
        return {}

    def is_named_nowhere(self, path: str) -> bool:
        """Return whether only modules name a module that are not named by anything in use themselves."""
        if not self.table.knows("executable"):
            return False
        found, waiting = {path}, [path]
        while waiting:
            one = waiting.pop()
            if self.is_in_use(one):
                return False
            around = [each for each in self.mentions.naming(one) if each not in found]
            found.update(around)
            waiting += around
        return True

    def is_in_use(self, path: str) -> bool:
        """Return whether a file is no installed module, or one that is started, imported, or there for others."""
        if self.has(path):
            return True
        module = self.installed.names[path]
        return module in self.entries or (self.is_library and module in self.started)

    def is_for_launch(self, path: str) -> bool:
        """Return whether a file is a module that only launch files import or name, directly or by other modules."""
        name = self.installed.names.get(path, "")
        return name in self.all and name not in self.without_launch

    def is_optional(self, path: str) -> bool:
        """Return whether a file is a module that others import, each where that may fail, and nothing else names."""
        module = self.installed.names.get(path, "")
        uses = self.imports.uses.get(module, [])
        return bool(uses) and all(each.is_optional for _, each in uses) and not self.is_wanted(path)

    def is_wanted(self, path: str) -> bool:
        """Return whether a module is started, or named by a text that is no module."""
        module = self.installed.names.get(path, "")
        starts = any(row.source == path for row in self.table.of("executable")) or module in self.entries
        return starts or self.mentions.is_named(module, ("run", "launch", "test"))

    @property
    def entries(self) -> list[str]:
        """The modules of entry points."""
        return [row.entry.partition(":")[0] for row in self.table.of("executable") if row.entry]

    @cached_property
    def all(self) -> frozenset[str]:
        """The installed modules that other files import or name, and those that these import."""
        return self.reached_from(("run", "launch", "test"))

    @cached_property
    def without_launch(self) -> frozenset[str]:
        """Those of them that are reached from a file that is no launch file."""
        return self.reached_from(("run", "test"))

    def reached_from(self, roles: tuple[Role, ...]) -> frozenset[str]:
        """Return the installed modules that files of some roles import or name, and those that these import.

        On its way to a module Python runs the `__init__.py` of each package that it is in.
        """
        names, programs = self.installed.names, {row.source for row in self.table.of("executable")}
        waiting = [name for name in self.installed.sources if "." not in name or self.mentions.is_named(name, roles)]
        for role, file in self.run.files:
            if role in roles and (file.path not in names or file.path in programs):
                for each in file.imports:
                    waiting += self.imports.imported_by(each, file.path)
        return self.imports.imported_from(waiting, around=True)

"""Which of a package's own modules are imported when what it starts, launches or tests is run."""

from __future__ import annotations

import re
from collections.abc import Iterator
from functools import cached_property

from ..languages.python.file import Import, PythonFile
from ..lazy_regex import regex
from ..light_dataclasses import dataclass
from ..package.cmake.cmake_project import CMake
from ..package.file_role import Role, role_of
from ..package.install_table import InstallTable
from ..package.launch.live_text import live_text
from .paths.home_path_texts import without_comments
from .python.installed_modules import InstalledModules
from .python.plain_scripts import is_run_by_path
from .python.run_imports import RunImports

PAGES = (".md", ".rst", ".sh")
"""Files that may tell how a module is started by its path."""

PROSE = (".md", ".rst")
"""Files in which a `#` begins no comment."""
SCRIPTS = regex(r"\bscripts\s*=")
NAMING = (".py", ".cfg", ".toml", ".xml", ".yaml", ".yml", ".urdf", ".xacro", ".txt", ".launch")
"""Files that name modules: entry points, plugins, launch files."""


@dataclass(frozen=True)
class ReachedModules:
    installed: InstalledModules
    run: RunImports
    table: InstallTable
    cmake: CMake | None = None

    @cached_property
    def is_library(self) -> bool:
        """Whether the package has modules for others alone: it is known that it installs no program."""
        programs = any(self.table.of("executable"))
        return not programs and self.table.knows("executable") and self.table.knows("module")

    @cached_property
    def started(self) -> frozenset[str]:
        """The installed modules that entry points start, and those that these import.

        Of a library it is every module that does nothing when it is started by its path, nor serves one that does. One
        that works when it is imported, and has nothing to import, is for no other code either.
        """
        waiting = self.entries
        if self.is_library:
            files = {module: self.run.modules.at(source) for module, source in self.installed.sources.items()}
            programs = [module for module, file in files.items() if file and is_run_by_path(file)]
            beside = self.found_beside(programs)
            waiting += [module for module, file in files.items() if file and module not in beside]
        return self.imported_from(waiting)

    def found_beside(self, programs: list[str]) -> set[str]:
        """Return some modules and those that Python finds in their folder when they are started by their path."""
        found, waiting = set[str](), [*programs]
        while waiting:
            module = waiting.pop()
            source = self.installed.sources.get(module, "")
            file = self.run.modules.at(source) if source and module not in found else None
            if file is not None:
                found.add(module)
                package = module.rpartition(".")[0]
                waiting += [f"{package}.{each.module}" for each in file.imports if not each.level]
        return found

    def has(self, path: str) -> bool:
        """Return whether a file is no installed module, or one that something else imports or names."""
        name = self.installed.names.get(path)
        return name is None or name in self.all

    def is_left(self, path: str) -> bool:
        """Return whether a file is a module that nothing of the package starts, imports or names, beside programs.

        Of a library it is one that does something when it is started by its path, or serves such a one alone.
        """
        if path not in self._left:
            self._left[path] = self.is_named_nowhere(path)
        return self._left[path]

    @cached_property
    def _left(self) -> dict[str, bool]:
        return {}

    def is_named_nowhere(self, path: str) -> bool:
        """Return whether no text names a module, but those of modules that nothing names either."""
        if not self.table.knows("executable"):
            return False
        found, waiting = {path}, [path]
        while waiting:
            one = waiting.pop()
            if self.is_in_use(one):
                return False
            around = [each for each in self.naming(one) if each not in found]
            found.update(around)
            waiting += around
        return True

    def is_in_use(self, path: str) -> bool:
        """Return whether a file is no installed module, or one that is started, imported, or there for others."""
        if self.has(path):
            return True
        module = self.installed.names[path]
        return module in self.entries or (self.is_library and module in self.started)

    def naming(self, path: str) -> Iterator[str]:
        """Yield the files that name a module by its file or its dotted name."""
        words = path.rpartition("/")[2], self.installed.names[path]
        word = re.compile(rf"(?<!\w)(?:{'|'.join(map(re.escape, words))})(?!\w)")  # `a.dot` is not named by `a.dot_qt`
        pages = (each for each in self.installed.files.paths if each.endswith((*PAGES, *NAMING)))
        others = {path, "setup.py", *self.laid_down} if path in self.put_beside else {path, *self.laid_down}
        return (each for each in pages if each not in others and self.names(each, word, *words))

    @cached_property
    def put_beside(self) -> frozenset[str]:
        """The modules that `data_files` puts beside the programs as well, for these to import: no one starts them so.

        What `scripts` names is a program.
        """
        if SCRIPTS.search(self.installed.files.readable_text("setup.py")):
            return frozenset()
        rows = (row for row in self.table.of("executable") if row.path == "setup.py" and not row.entry)
        return frozenset(row.source for row in rows if row.source in self.installed.names)

    def names(self, path: str, word: re.Pattern[str], *words: str) -> bool:
        """Return whether a text names a module by one of some words; a comment of code or of a list does not.

        A plain search goes first: data of many megabytes may be a `.txt`, and a pattern takes a hundred times as long.
        """
        text = self.installed.files.readable_text(path)
        if not any(each in text for each in words):
            return False
        if path.endswith(PROSE) or not word.search(text):
            return bool(word.search(text))
        bare = without_comments(path, text) if path.endswith(".py") else live_text(self.installed.files, path)
        return bool(word.search(bare))

    def is_for_launch(self, path: str) -> bool:
        """Return whether a file is a module that only launch files import or name, at first or second hand."""
        name = self.installed.names.get(path, "")
        return name in self.all and name not in self.without_launch

    def is_optional(self, path: str) -> bool:
        """Return whether a file is a module that others import, each where that may fail, and nothing else names."""
        module = self.installed.names.get(path, "")
        uses = self.uses.get(module, [])
        return bool(uses) and all(each.is_optional for _, each in uses) and not self.is_wanted(path)

    def is_wanted(self, path: str) -> bool:
        """Return whether a module is started, or named by a text that is no module."""
        module = self.installed.names.get(path, "")
        starts = any(row.source == path for row in self.table.of("executable")) or module in self.entries
        return starts or self.is_named(module, ("run", "launch", "test"))

    @cached_property
    def uses(self) -> dict[str, list[tuple[PythonFile, Import]]]:
        """Module → each import that means it, with its file; Python finds it in the same folder, too."""
        found: dict[str, list[tuple[PythonFile, Import]]] = {}
        for _, file in self.run.files:
            folder = self.installed.names.get(file.path, "").rpartition(".")[0]
            for each in file.imports:
                beside = [f"{folder}.{each.module}"] if folder and not each.level else []
                for name in dict.fromkeys((*self.imported_by(each, file.path), *beside)):
                    found.setdefault(name, []).append((file, each))
        return found

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
        """Those of them that are reached from another file than a launch file."""
        return self.reached_from(("run", "test"))

    def reached_from(self, roles: tuple[Role, ...]) -> frozenset[str]:
        """Return the installed modules that files of some roles import or name, and those that these import.

        On its way to a module Python runs the `__init__.py` of each package that it is in.
        """
        names, programs = self.installed.names, {row.source for row in self.table.of("executable")}
        waiting = [name for name in self.installed.sources if "." not in name or self.is_named(name, roles)]
        for role, file in self.run.files:
            if role in roles and (file.path not in names or file.path in programs):
                for each in file.imports:
                    waiting += self.imported_by(each, file.path)
        return self.imported_from(waiting, around=True)

    def is_named(self, module: str, roles: tuple[Role, ...]) -> bool:
        """Return whether a text of the package that is no installed module names one."""
        word, files = re.compile(rf"(?<![\w.]){re.escape(module)}(?!\w)"), self.installed.files
        others = {*self.installed.names, *self.laid_down}
        paths = (path for path in files.paths if path.endswith(NAMING) and path not in others)
        return any(self.names(path, word, module) for path in paths if role_of(path) in (*roles, "aside"))

    @cached_property
    def laid_down(self) -> frozenset[str]:
        """The scripts that a comment alone installs, and that nothing names: what they import serves nobody."""
        if self.cmake is None:
            return frozenset()
        from .cmake.laid_down_scripts import laid_down_scripts  # what few packages have

        return laid_down_scripts(self.cmake, self.installed.files, [each.path for each in self.run.python.files])

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

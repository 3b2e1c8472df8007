"""Rule input: texts of a package that name one of its Python modules: pages, launch files, code, configuration."""

from __future__ import annotations

import re
from collections.abc import Iterator
from functools import cached_property

from ..lazy_regex import regex
from ..light_dataclasses import dataclass
from ..package.cmake.cmake_project import CMake
from ..package.file_role import Role, role_of
from ..package.install_table import InstallTable
from ..package.launch.live_text import live_text
from .paths.home_path_texts import without_comments
from .python.installed_modules import InstalledModules
from .python.run_imports import RunImports

PAGES = (".md", ".rst", ".sh")
"""Files that may say how a module is started by its path."""
PROSE = (".md", ".rst")
"""Files in which a `#` begins no comment."""
SCRIPTS = regex(r"\bscripts\s*=")
"""The argument of `setup()` that installs programs."""
NAMING = (".py", ".cfg", ".toml", ".xml", ".yaml", ".yml", ".urdf", ".xacro", ".txt", ".launch")
"""Files that name modules: entry points, plugins, launch files."""


@dataclass(frozen=True)
class ModuleMentions:
    installed: InstalledModules
    run: RunImports
    table: InstallTable
    cmake: CMake | None = None

    def is_named(self, module: str, roles: tuple[Role, ...]) -> bool:
        """Return whether a file of the package that is no installed module itself names a module."""
        word, files = re.compile(rf"(?<![\w.]){re.escape(module)}(?!\w)"), self.installed.files
        others = {*self.installed.names, *self.laid_down}
        paths = (path for path in files.paths if path.endswith(NAMING) and path not in others)
        return any(self.names(path, word, module) for path in paths if role_of(path) in (*roles, "aside"))

    @cached_property
    def laid_down(self) -> frozenset[str]:
        """The scripts that only a commented line of CMake installs, and that nothing names: they are never run."""
        if self.cmake is None:
            return frozenset()
        from .cmake.scripts_in_comments import scripts_in_comments  # what few packages have

        return scripts_in_comments(self.cmake, self.installed.files, [each.path for each in self.run.python.files])

    def naming(self, path: str) -> Iterator[str]:
        """Yield the files that name a module by its file or its dotted name."""
        words = path.rpartition("/")[2], self.installed.names[path]
        word = re.compile(rf"(?<!\w)(?:{'|'.join(map(re.escape, words))})(?!\w)")  # `a.dot` is not named by `a.dot_qt`
        pages = (each for each in self.installed.files.paths if each.endswith((*PAGES, *NAMING)))
        others = {path, "setup.py", *self.laid_down} if path in self.put_with_programs else {path, *self.laid_down}
        return (each for each in pages if each not in others and self.names(each, word, *words))

    @cached_property
    def put_with_programs(self) -> frozenset[str]:
        """The modules that `data_files` also installs next to the programs, for these to import.

        Empty where setup.py has `scripts`: what that names is a program.
        """
        if SCRIPTS.search(self.installed.files.readable_text("setup.py")):
            return frozenset()
        rows = (row for row in self.table.of("executable") if row.path == "setup.py" and not row.entry)
        return frozenset(row.source for row in rows if row.source in self.installed.names)

    def names(self, path: str, word: re.Pattern[str], *words: str) -> bool:
        """Return whether a file names a module by one of some words, outside of comments.

        A plain search goes first: a `.txt` may hold many megabytes of data, for which a pattern takes a hundred times
        as long.
        """
        text = self.installed.files.readable_text(path)
        if not any(each in text for each in words):
            return False
        if path.endswith(PROSE) or not word.search(text):
            return bool(word.search(text))
        bare = without_comments(path, text) if path.endswith(".py") else live_text(self.installed.files, path)
        return bool(word.search(bare))

"""A quick look at the names and texts of a package's files: some values its facts certainly do not hold.

It may say of a value that it is worth looking for and it is not there, never the other way round but for names that a
script puts together from pieces which nothing shows.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from functools import cached_property

from ..files import PackageFiles
from ..lazy_regex import regex
from ..light_dataclasses import dataclass

SETUP_FILES = ("setup.py", "setup.cfg", "pyproject.toml")
CMAKE_FILES = ("CMakeLists.txt", ".cmake")
INSTALLS_PYTHON = regex(
    "python_install|PYTHON_INSTALL|pybind|nanobind|[Pp]ython3?_add|[Ss]ite.?(packages|arch|lib)|SITE"
)
LAUNCH_ENDINGS = (".py", ".xml", ".yaml", ".yml", ".launch")
MODULE_ENDINGS = (".py", ".pyi", ".pyx", ".so")


@dataclass(frozen=True)
class QuickLook:
    files: PackageFiles
    package: str
    """Its name."""

    def may_have(self, field: str, value: Sequence[str]) -> bool:
        """Return whether a field of the facts of the package may hold a value; see `Workspace.having`."""
        if field == "modules":
            return self.may_have_module(value[0].partition(".")[0])
        if field == "header_files":
            return value[0].rpartition("/")[2] in self.names
        if field == "started_nodes":
            return self.has_in(LAUNCH_ENDINGS, value[0])
        return True

    def may_have_module(self, top: str) -> bool:
        """Return whether a module of a name without dots may be installed: there is a file, or the build names it."""
        return self.package in top or top in self.modules or self.is_named_in_build(top)

    @cached_property
    def modules(self) -> frozenset[str]:
        """The names of all Python files, and of the folders of packages."""
        files = [path.split("/") for path in self.files.paths if path.endswith(MODULE_ENDINGS)]
        folders = {parts[-2] for parts in files if len(parts) > 1 and parts[-1] == "__init__.py"}
        return frozenset(folders | {parts[-1].partition(".")[0] for parts in files})

    def is_named_in_build(self, name: str) -> bool:
        """Return whether setup.py or the like holds a word, or a CMake file that installs Python."""
        word = re.compile(rf"\b{re.escape(name)}\b")
        return any(word.search(text) for text in self.build_texts)

    @cached_property
    def build_texts(self) -> tuple[str, ...]:
        cmake = (self.files.readable_text(path) for path in self.files.paths if path.endswith(CMAKE_FILES))
        setup = (self.files.readable_text(path) for path in SETUP_FILES if self.files.exists(path))
        return (*(text for text in cmake if INSTALLS_PYTHON.search(text)), *setup)

    def has_in(self, endings: tuple[str, ...], word: str) -> bool:
        """Return whether the text of a file with one of some endings holds a word."""
        return any(word in self.files.readable_text(path) for path in self.files.paths if path.endswith(endings))

    @cached_property
    def names(self) -> frozenset[str]:
        """The names of all files."""
        return frozenset(path.rpartition("/")[2] for path in self.files.paths)

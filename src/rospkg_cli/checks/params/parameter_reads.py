"""Rule input: the parameters that the code of a package gets, and those that may be declared somewhere."""

from __future__ import annotations

from collections.abc import Collection, Iterator
from functools import cached_property
from typing import TYPE_CHECKING

from ...languages.cpp.file import CppFile
from ...languages.python.file import PythonFile
from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...package.package_facts import PackageFacts
from ...package.params.declared_parameter import DeclaredParameter
from ...package.python.python_imports import PackageImports
from ...package.python_modules import PythonModules
from ...package.workspace import Workspace
from ...source import Source
from .own_python_reads import OwnPythonReads

if TYPE_CHECKING:
    from .own_reads import OwnReads

ALLOWED = ("allow_undeclared_parameters", "automatically_declare_parameters_from_overrides")
"""Node options that give a node parameters which no code declares."""
MAIN = regex(r"\bint\s+main\s*\(")


@dataclass(frozen=True)
class ParameterReads:
    """What the code of a package gets, and what its code and that of its neighbours declares."""

    cpp: tuple[CppFile, ...]
    modules: PythonModules
    package: PackageFacts
    workspace: Workspace
    python: PackageImports

    @cached_property
    def own(self) -> OwnReads:
        from .own_reads import OwnReads  # what packages in Python don't need

        return OwnReads(self.cpp)

    @cached_property
    def own_python(self) -> OwnPythonReads:
        return OwnPythonReads(tuple(self.run_files))

    @property
    def run_files(self) -> Iterator[PythonFile]:
        """The modules and programs in Python."""
        paths = sorted(each.path for each in self.python.files if each.role == "run")
        return (file for path in paths if (file := self.modules.at(path)))

    def unread(self, path: str, reads: Collection[DeclaredParameter]) -> set[str]:
        """Return the names that a file declares and no code of the package gets."""
        own = [each for each in self.package.parameters if each.path == path]
        return {each.name for each in own if not any(same(each, read) for read in reads)}

    @cached_property
    def every_python(self) -> tuple[PythonFile, ...]:
        """All Python files that can be parsed."""
        paths = (path for path in self.modules.files.paths if path.endswith(".py"))
        return tuple(file for path in paths if (file := self.modules.at(path)))

    @cached_property
    def programs(self) -> frozenset[str]:
        """The C++ files that have a `main`."""
        return frozenset(file.path for file in self.cpp if MAIN.search(file.source.text))

    def is_declared(self, read: DeclaredParameter, path: str = "") -> bool:
        """Return whether any code may declare what a file reads; of a program with `main`, no other such program."""
        others = self.programs - {path} if path in self.programs else frozenset[str]()
        here = [each for each in self.package.parameters if each.path not in others]
        if any(same(each, read) or (each.tail and read.name.endswith(each.name)) for each in here):
            return True
        packages = (facts for facts in self.workspace.packages if facts is not self.package)
        return any(same(each, read) for facts in packages for each in facts.parameters)


def allows_any(source: Source) -> bool:
    """Return whether a node of a file may have parameters that no code declares."""
    return any(word in source.text for word in ALLOWED)


def same(declared: DeclaredParameter, read: DeclaredParameter) -> bool:
    """Return whether a read may get what is declared; of either, only the end of the name may be known."""
    return declared.name == read.name or declared.fits(read.name) or read.fits(declared.name)

"""Rule input: the Python files of a package that run, and what they import for certain."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cached_property

from ...languages.python.file import PythonFile
from ...languages.python.imports import Import
from ...light_dataclasses import dataclass
from ...package.file_role import Role, is_set_aside, role_of
from ...package.python.python_imports import PackageImports
from ...package.python_modules import PythonModules
from .ros1_import import ros1_import

PATHS = ("sys.path", "PYTHONPATH", "addsitedir", "sys.meta_path")
"""What names the folders in which Python looks for modules."""


@dataclass(frozen=True)
class RunImports:
    python: PackageImports
    modules: PythonModules

    @cached_property
    def files(self) -> tuple[tuple[Role, PythonFile], ...]:
        """The files that can be read, with their roles; none that ends at a module of ROS 1."""
        read = ((each.role, self.modules.at(each.path)) for each in self.python.files)
        return tuple((role, file) for role, file in read if file is not None and ros1_import(file.imports) is None)

    @property
    def running(self) -> Iterator[PythonFile]:
        """The files that are installed, launched, or run as tests."""
        return (file for role, file in self.files if role != "aside")

    @property
    def certain(self) -> Iterator[tuple[PythonFile, Import]]:
        """The imports that are not optional, with their files."""
        for file in self.running:
            for each in file.imports:
                if not each.is_optional and not each.is_for_typing:
                    yield file, each

    @property
    def uninstalled(self) -> Iterator[tuple[PythonFile, Import]]:
        """The same for files that nothing installs, and that may be run where they lie."""
        for role, file in self.files:
            if role == "aside" and role_of(file.path) == "run" and not is_set_aside(file.path):
                for each in file.imports:
                    if not each.is_optional and not each.is_for_typing:
                        yield file, each

    @cached_property
    def changes_path(self) -> bool:
        """Whether a file that is no test has Python look for modules in other folders."""
        texts = (file.source.text for role, file in self.files if role in ("run", "launch"))
        return any(word in each for each in texts for word in PATHS)

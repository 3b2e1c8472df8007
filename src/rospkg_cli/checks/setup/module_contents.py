"""What the modules of a package define, and what they do when they are imported (SET102)."""

from __future__ import annotations

import ast

from ...languages.python.file import PythonFile
from ...languages.python.nodes import nodes_of_kind
from ...light_dataclasses import dataclass
from ...suggest import slips
from ..python.ros1_import import ros1_import
from .module_exports import offers
from .python_package import PythonPackage


@dataclass(frozen=True)
class ModuleContents:
    package: PythonPackage

    def file(self, module: str) -> PythonFile | None:
        """Return the file of a module of the package; None where it is not there or can't be read."""
        return self.package.modules.at(self.package.setup.file_of(module) or "")

    def has_attribute(self, module: str, name: str) -> bool:
        """Return whether a module has a name, or may have it, and it is no misspelling of one that it defines."""
        path, first = self.package.setup.file_of(module), name.partition(".")[0]
        return path is None or (
            offers(self.package.modules, self.package.setup, path, first) and not self.is_slip(path, first)
        )

    def is_slip(self, path: str, name: str) -> bool:
        """Return whether a name is a misspelling of one that a file itself defines, even if it imports `*`."""
        file = self.package.modules.at(path)
        if file is None or file.has_dynamic_names or name in file.definitions:
            return False
        return bool(slips(name, file.definitions))

    def runs_when_imported(self, module: str) -> bool:
        """Return whether a module runs its program as soon as it is imported."""
        file = self.file(module)
        return file is not None and file.runs_when_imported

    def is_webots_driver(self, module: str) -> bool:
        """Return whether a module has a class with `init` and `step`, which Webots loads by its name."""
        file = self.file(module)
        classes = nodes_of_kind(file.tree, ast.ClassDef) if file is not None else ()
        methods = ({each.name for each in one.body if isinstance(each, ast.FunctionDef)} for one in classes)
        return any({"init", "step"} <= names for names in methods)

    def ros1_module(self, module: str) -> str:
        """Return the module of ROS 1 at which the import of a module fails; "" for none."""
        file = self.file(module)
        found = ros1_import(file.imports) if file is not None else None
        return found.module if found is not None else ""

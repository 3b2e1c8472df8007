"""Modules that an entry point names and that a package does not have (SET101)."""

from __future__ import annotations

import posixpath

from ...light_dataclasses import dataclass
from ...package.setup.setup_py import SetupPy
from ...ros.imports import STANDARD
from ...suggest import nearest
from .python_package import PythonPackage


@dataclass(frozen=True)
class MissingModules:
    package: PythonPackage

    @property
    def setup(self) -> SetupPy:
        return self.package.setup

    def has(self, module: str) -> bool:
        """Return whether a module that must be of this package does not exist."""
        setup = self.setup
        if (
            module.rpartition(".")[2] in setup.generated
            or setup.may_write_files
            or not setup.knows("package_dir")
            or setup.file_of(module)
            or self.is_of_missing_folder(module)
            or self.may_be_generated(module)
            or self.is_expected(module)
        ):
            return False
        return module.partition(".")[0] in self.package.roots or self.misplaced(module) is not None

    def is_of_missing_folder(self, module: str) -> bool:
        """Return whether `packages` lists the package of a module, and its folder is missing: the build stops there."""
        setup, package = self.setup, module.rpartition(".")[0]
        is_listed = not setup.searches and package in setup.package_names
        return is_listed and setup.kind(setup.folder_of(package)) is None

    def is_expected(self, module: str) -> bool:
        """Return whether git ignores the file of a module, or a submodule that is not checked out may hold it."""
        package, _, name = module.rpartition(".")
        folder = self.setup.folder_of(package) if package else self.setup.package_dir.get("", "")
        return self.package.files.absent.is_expected(posixpath.join(folder, f"{name}.py"))

    def may_be_generated(self, module: str) -> bool:
        """Return whether something else may provide a module: an extension, a template, the target of a link."""
        package, _, name = module.rpartition(".")
        folder = self.setup.folder_of(package) if package else self.setup.package_dir.get("", "")
        if self.setup.kind(posixpath.normpath(folder or ".").removeprefix(".")) == "unknown":
            return True
        names = self.setup.folder.children.get(folder, {})
        return (
            any(each.startswith(f"{name}.") and each != f"{name}.pyi" for each in names) or names.get(name) == "unknown"
        )

    def misplaced(self, module: str) -> str | None:
        """Return the module of this package that a name from outside probably refers to; None where there is none.

        The package's name is missing, or another one is in its place: the module is the same without the first part of
        its name. Names of the standard library and of packages that package.xml depends on refer to these.
        """
        root, _, rest = module.partition(".")
        if root in STANDARD or self.package.manifest.depends_on(root):
            return None
        tails = {other.partition(".")[2]: other for other in self.package.on_disk}
        return tails.get(module) or (tails.get(rest) or tails.get(root) if rest else None)

    def suggestion(self, module: str) -> str | None:
        """Return the most similar module of the package that no entry point names."""
        if (found := self.misplaced(module)) is not None:
            return found
        last, started = module.rpartition(".")[2], {entry.module for entry in self.setup.entry_points}
        modules = (other for other, path in self.package.on_disk.items() if not path.endswith("/__init__.py"))
        free = [other for other in modules if other not in started]
        same = [other for other in free if other.rpartition(".")[2] == last]
        return same[0] if len(same) == 1 else nearest(module, free)

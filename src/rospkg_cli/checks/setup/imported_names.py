"""The names that modules and entry points of a package import, and which folders of modules they need."""

from __future__ import annotations

from functools import cached_property

from ...light_dataclasses import dataclass
from ...package.file_role import role_of
from ...package.setup.setup_py import SetupPy
from .module_exports import absolute
from .python_package import PythonPackage


@dataclass(frozen=True)
class ImportedNames:
    package: PythonPackage

    @property
    def setup(self) -> SetupPy:
        return self.package.setup

    @cached_property
    def imported(self) -> frozenset[tuple[str, str]]:
        """Every dotted name that a module or an entry point refers to, with the file that does."""
        found = {(entry.module, entry.path) for entry in self.setup.entry_points}
        for path in self.package.on_disk.values():
            file = self.package.modules.at(path)
            for each in file.imports if file else ():
                module = absolute(each, path, self.setup)
                found |= {(module, path), *[(f"{module}.{name}", path) for name in each.names]}
        return frozenset(found)

    def dotted(self, folder: str) -> str:
        """Return the name under which a folder of modules would be imported."""
        base = self.setup.package_dir.get("", "")
        return (folder[len(base) + 1 :] if base and folder.startswith(f"{base}/") else folder).replace("/", ".")

    def is_imported_elsewhere(self, folder: str) -> bool:
        """Return whether code of the repository outside of a folder imports what is in it."""
        from .imported_in_repository import is_imported_in_repository  # imported for findings alone

        return is_imported_in_repository(self.package.files, folder, self.dotted(folder))

    def imports_from(self, folder: str) -> bool:
        """Return whether a module of the package outside of a folder, or an entry point, needs what is in it.

        Tests do not count: pytest imports them where the source is, and Python needs no `__init__.py` there.
        """
        wanted = self.dotted(folder)
        users = ((name, path) for name, path in self.imported if not inside(path, folder) and role_of(path) != "test")
        return any(name == wanted or name.startswith(f"{wanted}.") for name, _ in users)

    def is_installed_in_parts(self, package: str) -> bool:
        """Return whether `py_modules` installs all modules that are imported from a package missing in `packages`."""
        if all(said.text.rpartition(".")[0] != package for said in self.setup.py_modules):
            return False
        paths = {m: path for m, path in self.package.on_disk.items() if m.rpartition(".")[0] == package}
        left = {m for m, path in paths.items() if m not in self.setup.modules and not path.endswith("/__init__.py")}
        return left.isdisjoint(name for name, _ in self.imported)


def inside(path: str, folder: str) -> bool:
    """Return whether a path is below a folder."""
    return path.startswith(f"{folder}/")

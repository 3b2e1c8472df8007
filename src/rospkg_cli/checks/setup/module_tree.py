"""Rule input: the Python packages and modules of a package that setup.py does not install."""

from __future__ import annotations

import posixpath
from functools import cached_property
from typing import TYPE_CHECKING

from ...light_dataclasses import dataclass
from ...package.file_role import is_set_aside
from ...package.setup.entry_point import EntryPoint
from ...package.setup.setup_py import SetupPy
from ...package.setup.setup_text import SetupText
from ..repository.linked_build import is_always_linked, linking_file
from .imported_names import ImportedNames
from .missing_inits import TESTS, MissingInits
from .python_package import PythonPackage

if TYPE_CHECKING:
    from .started_imports import StartedImports


@dataclass(frozen=True)
class ModuleTree:
    package: PythonPackage

    @property
    def setup(self) -> SetupPy:
        return self.package.setup

    @cached_property
    def names(self) -> ImportedNames:
        return ImportedNames(self.package)

    @cached_property
    def missing_inits(self) -> tuple[str, ...]:
        """The folders of modules without an `__init__.py`."""
        return MissingInits(self.names).every()

    @cached_property
    def missing_folders(self) -> tuple[SetupText, ...]:
        """The packages that `packages` lists and that have no folder: setuptools stops at the first one."""
        setup = self.setup
        folders = ((said, setup.folder_of(said.text)) for said in setup.packages if not setup.searches)
        absent = self.package.files.absent
        return tuple(said for said, folder in folders if setup.kind(folder) is None and not absent.is_expected(folder))

    @property
    def has_unnamed_package(self) -> bool:
        """Whether setup() names no packages and no modules, though there is a package with the manifest's name.

        It is False where something else names or explains them: pyproject.toml, extension modules, and the findings on
        a misspelt argument or on entry points whose package is not listed.
        """
        setup, own = self.setup, self.package.name
        named = setup.packages or setup.py_modules or setup.argument("packages") or setup.argument("py_modules")
        init = posixpath.join(setup.folder_of(own), "__init__.py")
        if named or setup.argument("ext_modules") or setup.call is None or setup.misspelt_arguments:
            return False
        has_modules = any(module.startswith(f"{own}.") for module in self.package.on_disk)
        is_elsewhere = self.package.files.exists("pyproject.toml") or self.not_installed()
        return has_modules and setup.kind(init) == "file" and not is_elsewhere

    def not_installed(self) -> dict[str, list[tuple[EntryPoint, str]]]:
        """Return, by unlisted package, the entry points with a module in it, each with the path of that module."""
        found: dict[str, list[tuple[EntryPoint, str]]] = {}
        for entry in self.setup.entry_points:
            module = entry.module.removesuffix(".__init__")
            path = self.setup.file_of(module) if module and not entry.fault else None
            if path is None or module in self.setup.modules or posixpath.dirname(path) in self.missing_inits:
                continue
            inner = module if path.endswith("/__init__.py") else module.rpartition(".")[0]
            found.setdefault(inner, []).append((entry, path))
        return found

    @cached_property
    def linking(self) -> str:
        """The file of the repository that builds the package with `--symlink-install`; "" for none."""
        return linking_file(self.package.files)

    def link_of(self, *packages: str) -> str:
        """Return the file that builds with `--symlink-install`, if that makes some Python packages importable, or "".

        colcon links the folder of each listed package without a dot in its name, with everything below.
        """
        names = self.setup.package_names
        is_reached = bool(packages) and all(each.partition(".")[0] in names for each in packages)
        return self.linking if is_reached else ""

    @cached_property
    def is_always_linked(self) -> bool:
        return is_always_linked(self.package.files, self.package.name)

    def holds_launch_files(self, folder: str) -> bool:
        """Return whether a folder has the name of one for launch files, and nothing imports it."""
        return posixpath.basename(folder) in ("launch", "launches") and not self.names.imports_from(folder)

    def is_set_aside(self, folder: str) -> bool:
        """Return whether a folder is for unused code, by its name: `old/`, `backup/`."""
        return is_set_aside(f"{folder}/")

    def may_be_for_others(self, folder: str) -> bool:
        """Return whether modules that no program here needs may serve a package that depends on this one."""
        return self.package.workspace.is_needed(self.package.name) and self.names.is_imported_elsewhere(folder)

    @cached_property
    def started(self) -> StartedImports:
        from .started_imports import StartedImports  # imported for findings alone

        return StartedImports(self.package)

    @cached_property
    def unlisted(self) -> tuple[str, ...]:
        """The Python packages below listed ones that `packages` leaves out, without those of entry points."""
        listed = self.setup.package_names
        started = {entry.module.rpartition(".")[0] for entry in self.setup.entry_points}
        found: dict[str, None] = {}
        for name in sorted(
            {m.rpartition(".")[0] if not p.endswith("__init__.py") else m for m, p in self.package.on_disk.items()}
        ):
            parts = name.split(".")
            above = {".".join(parts[:i]) for i in range(1, len(parts))}
            path = self.package.on_disk.get(name, "")
            if (
                name not in listed | started
                and above & listed
                and path.endswith("__init__.py")
                and not TESTS & set(parts)
                and not self.names.is_installed_in_parts(name)
            ):
                found[name] = None
        return tuple(found)

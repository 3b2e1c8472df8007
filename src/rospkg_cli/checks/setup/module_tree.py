"""Rule input: the folders of Python modules of a package, against what is installed of them."""

from __future__ import annotations

import posixpath
from collections.abc import Iterator
from functools import cached_property
from typing import TYPE_CHECKING

from ...light_dataclasses import dataclass
from ...package.file_role import is_set_aside, role_of
from ...package.setup.entry_points import EntryPoint
from ...package.setup.setup_py import SetupPy
from ...package.setup.setup_text import SetupText
from ..repository.linked_build import is_always_linked, linking_file
from .module_exports import absolute
from .python_package import PythonPackage

if TYPE_CHECKING:
    from .started_imports import StartedImports

TESTS = frozenset({"test", "tests", "testing"})


@dataclass(frozen=True)
class ModuleTree:
    package: PythonPackage

    @property
    def setup(self) -> SetupPy:
        return self.package.setup

    @cached_property
    def missing_folders(self) -> tuple[SetupText, ...]:
        """The packages that `packages` lists and that have no folder: setuptools stops at the first."""
        setup = self.setup
        folders = ((said, setup.folder_of(said.text)) for said in setup.packages if not setup.searches)
        absent = self.package.files.absent
        return tuple(said for said, folder in folders if setup.kind(folder) is None and not absent.is_expected(folder))

    @property
    def has_unnamed_package(self) -> bool:
        """Return whether setup() names no packages and no modules at all, beside a package of the manifest's name.

        pyproject.toml may name them, extension modules are modules too, and a misspelt argument and entry points are
        told themselves.
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
        """Return the entry points whose module lies in a package that is not listed, each with its file, by package."""
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
        """The file of the repository that builds the package with links to its sources; "" for none."""
        return linking_file(self.package.files)

    def link_of(self, *packages: str) -> str:
        """Return the file that builds with links, where these reach some Python packages; "" else.

        colcon links the folder of each listed package without a dot in its name, and so all that is in it.
        """
        names = self.setup.package_names
        is_reached = bool(packages) and all(each.partition(".")[0] in names for each in packages)
        return self.linking if is_reached else ""

    @cached_property
    def is_always_linked(self) -> bool:
        return is_always_linked(self.package.files, self.package.name)

    @cached_property
    def missing_inits(self) -> tuple[str, ...]:
        """Folders of modules without an `__init__.py`: find_packages() skips them.

        Where `packages` is a list, those that are listed, and those below them that are not.
        """
        found: dict[str, None] = {}
        for search in self.setup.searches:
            if not search.namespace:
                for folder in (search.where, *[posixpath.join(search.where, *p.split(".")) for p in search.found]):
                    found |= dict.fromkeys(self.without_init(folder, top=folder == search.where))
        listed = (
            {} if self.setup.searches else {self.setup.folder_of(package.text): None for package in self.setup.packages}
        )
        for folder in listed:
            found |= {folder: None} if self.lacks_init(folder) else {}
            found |= {each: None for each in self.without_init(folder, top=False) if each not in listed}
        ignores = self.package.files.absent.is_ignored
        lacking = (folder for folder in found if not ignores(f"{folder}/__init__.py"))
        return tuple(folder for folder in lacking if not self.is_installed_in_parts(self.dotted(folder)))

    def lacks_init(self, folder: str) -> bool:
        """Return whether a folder holds modules and no `__init__.py`."""
        names = self.setup.folder.children.get(folder, {})
        return bool(folder) and "__init__.py" not in names and any(name.endswith(".py") for name in names)

    def without_init(self, folder: str, *, top: bool) -> Iterator[str]:
        children = self.setup.folder.children
        for name, kind in children.get(folder, {}).items():
            path = posixpath.join(folder, name)
            if kind != "dir" or not name.isidentifier() or name in TESTS or (top and name != self.package.name):
                continue
            if self.lacks_init(path):
                yield path

    def dotted(self, folder: str) -> str:
        """Return the name under which a folder of modules would be imported."""
        base = self.setup.package_dir.get("", "")
        return (folder[len(base) + 1 :] if base and folder.startswith(f"{base}/") else folder).replace("/", ".")

    def holds_launch_files(self, folder: str) -> bool:
        """Return whether a folder is called as one of launch files, and nothing imports it."""
        return posixpath.basename(folder) in ("launch", "launches") and not self.imports_from(folder)

    def is_set_aside(self, folder: str) -> bool:
        """Return whether a folder is for what nobody uses any more, by its name."""
        return is_set_aside(f"{folder}/")

    def may_be_for_others(self, folder: str) -> bool:
        """Return whether modules that nothing here starts are there for a package that depends on this one."""
        return self.package.workspace.is_needed(self.package.name) and self.is_imported_elsewhere(folder)

    def is_imported_elsewhere(self, folder: str) -> bool:
        """Return whether code of the repository outside of a folder imports what is in it."""
        from .imported_in_repository import is_imported_in_repository  # what findings alone need

        return is_imported_in_repository(self.package.files, folder, self.dotted(folder))

    def imports_from(self, folder: str) -> bool:
        """Return whether a module of the package outside of a folder, or an entry point, needs what is in it.

        Tests do not count: pytest imports them where the source is, and Python needs no `__init__.py` there.
        """
        wanted = self.dotted(folder)
        users = ((name, path) for name, path in self.imported if not inside(path, folder) and role_of(path) != "test")
        return any(name == wanted or name.startswith(f"{wanted}.") for name, _ in users)

    @cached_property
    def started(self) -> StartedImports:
        from .started_imports import StartedImports  # what findings alone need

        return StartedImports(self.package)

    @cached_property
    def imported(self) -> frozenset[tuple[str, str]]:
        """Every dotted name that modules or entry points refer to, with the file that does."""
        found = {(entry.module, entry.path) for entry in self.setup.entry_points}
        for path in self.package.on_disk.values():
            file = self.package.modules.at(path)
            for each in file.imports if file else ():
                module = absolute(each, path, self.setup)
                found |= {(module, path), *[(f"{module}.{name}", path) for name in each.names]}
        return frozenset(found)

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
                and not self.is_installed_in_parts(name)
            ):
                found[name] = None
        return tuple(found)

    def is_installed_in_parts(self, package: str) -> bool:
        """Return whether `py_modules` installs all that is imported of a package that `packages` leaves out."""
        if all(said.text.rpartition(".")[0] != package for said in self.setup.py_modules):
            return False
        paths = {m: path for m, path in self.package.on_disk.items() if m.rpartition(".")[0] == package}
        left = {m for m, path in paths.items() if m not in self.setup.modules and not path.endswith("/__init__.py")}
        return left.isdisjoint(name for name, _ in self.imported)


def inside(path: str, folder: str) -> bool:
    return path.startswith(f"{folder}/")

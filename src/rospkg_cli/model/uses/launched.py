"""Launch files against declarations: the packages that they need and package.xml does not name."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from ...ros.names import Known
from ...ros.stands_for import IN_LAUNCH_FILES, IN_TESTS, brought
from ..files import PackageFiles
from ..launch.file import LaunchFile
from ..launch.uses import PackageUse, package_uses
from .declared import Declared
from .python import OwnModules
from .roles import role_of
from .serving import serving_import


@dataclass(frozen=True)
class Launched:
    """The launch files of a package, and what it declares."""

    declared: Declared
    files: PackageFiles
    launch_files: tuple[LaunchFile, ...]

    @property
    def names_around(self) -> frozenset[str]:
        """The packages of the workspace and those that are declared."""
        return self.declared.workspace.names | self.declared.names

    def is_strange(self, name: str) -> bool:
        """Return whether nobody knows a package of that name."""
        return self.declared.workspace.what(name) is not Known.PACKAGE

    def missing(self, *, tests: bool) -> dict[str, list[PackageUse]]:
        """Return each package that is needed and not declared, with the places that need it."""
        if not self.declared.judged:
            return {}
        there = brought(self.declared.names, IN_TESTS if tests else IN_LAUNCH_FILES)
        found: dict[str, list[PackageUse]] = {}
        for file in self.launch_files:
            if (role_of(file.path) == "test") is tests:
                for use in [*package_uses(file), *([] if tests else self.imported(file))]:
                    if not self.declared.has([use.name]) and use.name not in there:
                        found.setdefault(use.name, []).append(use)
        return found

    def imported(self, file: LaunchFile) -> Iterator[PackageUse]:
        """Yield what a Python launch file imports and nothing declared serves."""
        own = OwnModules(self.files)
        for each in file.imports:
            if each.level or own.has(each.module, file.path):
                continue
            name = serving_import(self.declared, each)
            if name is not None:
                yield PackageUse(name, file.path, each.span, f"imports `{each.module}` of")

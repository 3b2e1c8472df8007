"""Folders of Python modules without an `__init__.py` (SET301)."""

from __future__ import annotations

import posixpath
from collections.abc import Iterator

from ...light_dataclasses import dataclass
from ...package.setup.setup_py import SetupPy
from .imported_names import ImportedNames

TESTS = frozenset({"test", "tests", "testing"})
"""Names of folders that setuptools need not install."""


@dataclass(frozen=True)
class MissingInits:
    names: ImportedNames

    @property
    def setup(self) -> SetupPy:
        return self.names.setup

    def every(self) -> tuple[str, ...]:
        """Return the folders of modules without an `__init__.py`, which find_packages() skips.

        Where `packages` is a list, these are the listed folders, and the unlisted ones below them.
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
        ignores = self.names.package.files.absent.is_ignored
        lacking = (folder for folder in found if not ignores(f"{folder}/__init__.py"))
        return tuple(folder for folder in lacking if not self.names.is_installed_in_parts(self.names.dotted(folder)))

    def lacks_init(self, folder: str) -> bool:
        """Return whether a folder holds modules and no `__init__.py`."""
        names = self.setup.folder.children.get(folder, {})
        return bool(folder) and "__init__.py" not in names and any(name.endswith(".py") for name in names)

    def without_init(self, folder: str, *, top: bool) -> Iterator[str]:
        """Yield the folders directly below a folder that lack one; `top` stands for where find_packages() starts."""
        children = self.setup.folder.children
        for name, kind in children.get(folder, {}).items():
            path = posixpath.join(folder, name)
            if kind != "dir" or not name.isidentifier() or name in TESTS or (top and name != self.names.package.name):
                continue
            if self.lacks_init(path):
                yield path

"""The modules that a package may import of itself."""

from __future__ import annotations

from functools import cached_property
from pathlib import PurePosixPath
from typing import cast

from ...files import PackageFiles
from ...light_dataclasses import dataclass

NO_PACKAGES = frozenset({"launch", "test", "tests", "config", "scripts"})
"""Folders without `__init__.py` that are not imported, though Python would import them."""


@dataclass(frozen=True)
class OwnModules:
    """The modules that a package may import of itself, by their first name."""

    paths: tuple[str, ...]

    @cached_property
    def everywhere(self) -> frozenset[str]:
        """Packages at any depth (a `src/` or a vendored copy may hold them), and modules in the folder of setup.py."""
        paths = [path.split("/") for path in self.paths if path.endswith(".py")]
        packages = {"".join(parts[-2:-1]) for parts in paths if parts[-1] == "__init__.py"}
        top = {parts[0] for parts in paths if len(parts) > 1} - NO_PACKAGES
        return frozenset(packages | top | {stem_of(parts[0]) for parts in paths if len(parts) == 1})

    @cached_property
    def _by_folder(self) -> dict[str, set[str]]:
        found: dict[str, set[str]] = {}
        for path in self.paths:
            if path.endswith((".py", ".so", ".pyi")):
                folder, _, name = path.rpartition("/")
                found.setdefault(folder, set()).add(name.partition(".")[0])
                above, _, name = folder.rpartition("/")
                found.setdefault(above, set()).add(name)
        return found

    def has(self, module: str, importer: str) -> bool:
        """Return whether an import in the file `importer` may refer to one of these."""
        top = module.partition(".")[0]
        return top in self.everywhere or top in self._by_folder.get(importer.rpartition("/")[0], ())


def stem_of(name: str) -> str:
    return PurePosixPath(name).stem


def own_modules(files: PackageFiles) -> OwnModules:
    """Return the modules of a package, the same for all that ask."""
    known = vars(files)
    if "own_modules" not in known:
        known["own_modules"] = OwnModules(files.paths)
    return cast(OwnModules, known["own_modules"])

"""Rule input: modules of a package that no build installs, and whether a program needs them."""

from __future__ import annotations

from ...light_dataclasses import dataclass
from .module_tree import ModuleTree
from .started_entry_points import StartedEntryPoints

LEFT = "; nothing here starts the programs that import it, as it does others of the package"


@dataclass(frozen=True)
class LostModules:
    tree: ModuleTree
    programs: StartedEntryPoints

    def left(self, package: str) -> str:
        """Return that nothing starts the programs that import a package at their start; "" where something may."""
        return LEFT if self.programs.left_all(self.tree.started.starting(package)) else ""

    def why_found(self, package: str) -> str:
        """Return why Python finds a package in its source folder, as by PYTHONPATH; "" where it is not known to."""
        from ..found_in_source import why_found  # imported for findings alone

        top = self.tree.setup.folder_of(package.partition(".")[0])
        return why_found(self.tree.package.files, top.rpartition("/")[0])

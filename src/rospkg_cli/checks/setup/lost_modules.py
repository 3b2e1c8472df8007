"""Rule input: modules of a package that no build installs, and whether anybody misses them."""

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
        """Return that nothing starts the programs whose start needs a Python package; "" where one may be."""
        return LEFT if self.programs.left_all(self.tree.started.starting(package)) else ""

    def why_found(self, package: str) -> str:
        """Return why Python finds a Python package where its source lies; "" where nothing is known to have it so."""
        from ..found_in_source import why_found  # what findings alone need

        top = self.tree.setup.folder_of(package.partition(".")[0])
        return why_found(self.tree.package.files, top.rpartition("/")[0])

"""Rule input: modules and scripts that other packages of the workspace may import."""

from __future__ import annotations

from ..light_dataclasses import dataclass
from ..package.package_facts import PackageFacts
from ..package.workspace import Workspace
from .python.plain_scripts import is_plain_script
from .reached_modules import ReachedModules


@dataclass(frozen=True)
class ModuleUsers:
    package: PackageFacts
    workspace: Workspace
    reached: ReachedModules | None = None

    def may_need(self, path: str) -> bool:
        """Return whether another package may import a file: it depends on this one and has Python modules.

        A script counts only where one does import it.
        """
        users = [each for each in self.workspace.needing(self.package.name) if each.modules]
        if not users or self.reached is None or not self.is_script(path):
            return bool(users)
        return self.is_imported(self.reached.installed.names.get(path, ""))

    def is_imported(self, name: str) -> bool:
        """Return whether a package of the workspace imports a module, by its dotted name."""
        taken = {taken for each in self.workspace.packages for taken in each.taken_names}
        return any(name in (module, f"{module}.{inner}") for module, inner in taken)

    def is_script(self, path: str) -> bool:
        """Return whether a file is Python that is run, and offers nothing to import (see `is_plain_script`)."""
        file = self.reached.run.modules.at(path) if self.reached is not None else None
        return file is not None and is_plain_script(file)

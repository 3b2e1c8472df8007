"""The files of a package together with its facts and its workspace."""

from __future__ import annotations

from ...files import PackageFiles
from ...light_dataclasses import dataclass
from ...package.package_facts import PackageFacts
from ...package.workspace import Workspace
from ..reached_modules import ReachedModules


@dataclass(frozen=True)
class FactsAndFiles:
    facts: PackageFacts
    files: PackageFiles
    workspace: Workspace
    reached: ReachedModules | None = None

    def is_left(self, path: str) -> bool:
        """Return whether nothing starts or imports a module; not of a file that Python can't read."""
        reached = self.reached
        return reached is not None and reached.run.modules.at(path) is not None and reached.is_left(path)

    @property
    def moved(self) -> frozenset[str]:
        """The interfaces of other packages of the workspace that are built: `msg/Name`."""
        others = (each for each in self.workspace.packages if each is not self.facts and each.is_ament)
        return frozenset(name for each in others for name in each.interfaces)

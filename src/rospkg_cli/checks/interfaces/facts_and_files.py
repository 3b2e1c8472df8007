"""The files of a package together with its facts and its workspace."""

from __future__ import annotations

from ...files import PackageFiles
from ...light_dataclasses import dataclass
from ...package.package_facts import PackageFacts
from ...package.workspace import Workspace


@dataclass(frozen=True)
class FactsAndFiles:
    facts: PackageFacts
    files: PackageFiles
    workspace: Workspace

    @property
    def moved(self) -> frozenset[str]:
        """The interfaces of other packages of the workspace that are built: `msg/Name`."""
        others = (each for each in self.workspace.packages if each is not self.facts and each.is_ament)
        return frozenset(name for each in others for name in each.interfaces)

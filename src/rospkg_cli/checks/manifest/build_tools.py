"""Which declared dependency brings the build tool that package.xml does not name (XML208)."""

from __future__ import annotations

from ...light_dataclasses import dataclass
from ...ros.manifest import BUILDS
from ..depends.brought_dependencies import brought_by
from ..depends.declared_dependencies import DeclaredDependencies
from .manifest_inputs import ManifestAndCMake


@dataclass(frozen=True)
class BuildTools:
    package: ManifestAndCMake
    declared: DeclaredDependencies

    def bringer(self, name: str) -> str:
        """Return what certainly brings a build tool wherever the package is built, the build farm included; else "".

        The build farm installs what is declared to build and to test; a test dependency is not asked here, since it may
        be left out.
        """
        needs = (each for each in self.declared.facts.dependencies if each.certain and each.tag in BUILDS)
        first = sorted(self.declared.closure(each.name for each in needs))
        return brought_by(first, self.declared.workspace).get(name, "")

"""Which declared dependency brings the build tool that package.xml does not name (XML208)."""

from __future__ import annotations

from ...light_dataclasses import dataclass
from ...ros.manifest import BUILDS
from ..depends.brought_dependencies import Bringer
from ..depends.declared_dependencies import DeclaredDependencies
from .manifest_and_cmake import ManifestAndCMake


@dataclass(frozen=True)
class BuildTools:
    package: ManifestAndCMake
    declared: DeclaredDependencies

    def bringer(self, name: str) -> Bringer | None:
        """Return what brings a build tool wherever the package is built, the build farm included, or may bring it.

        The build farm installs what is declared to build and to test; a test dependency is not asked here, since it may
        be left out.
        """
        return self.declared.brings.bringer_among([name], self.declared.brings.brought_with(BUILDS))

"""Rule input: a package with setup.py, and whether its repository is released: whose version users ask about."""

from __future__ import annotations

from ...light_dataclasses import dataclass
from ..repository.released import CHANGES, Release
from .python_package import PythonPackage


@dataclass(frozen=True)
class VersionedPackage:
    package: PythonPackage
    release: Release

    @property
    def is_released(self) -> bool:
        """Whether bloom, a job or the changes of all packages say so; a CHANGELOG.rst alone came with a copy."""
        has_changes = self.package.files.exists(CHANGES) and all(self.release.have_changes())
        return has_changes or self.release.is_made

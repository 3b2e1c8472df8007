"""Rule input: the license texts that package.xml names, and whether the package is released (XML106, XML107)."""

from __future__ import annotations

from ...files import PackageFiles
from ...light_dataclasses import dataclass
from ...package.manifest import Manifest
from ..repository.released import Release


@dataclass(frozen=True)
class LicenseFiles:
    manifest: Manifest
    files: PackageFiles
    release: Release

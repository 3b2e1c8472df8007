"""The files of a package together with its facts."""

from __future__ import annotations

from ...files import PackageFiles
from ...light_dataclasses import dataclass
from ...package.package_facts import PackageFacts


@dataclass(frozen=True)
class FactsAndFiles:
    facts: PackageFacts
    files: PackageFiles

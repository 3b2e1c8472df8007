"""The files of a package together with its facts."""

from __future__ import annotations

from dataclasses import dataclass

from ...files import PackageFiles
from ...package.package_facts import PackageFacts


@dataclass(frozen=True)
class FactsAndFiles:
    facts: PackageFacts
    files: PackageFiles

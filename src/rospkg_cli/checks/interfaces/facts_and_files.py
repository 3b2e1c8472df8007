"""The files of a package beside its facts."""

from __future__ import annotations

from dataclasses import dataclass

from ...files import PackageFiles
from ...package.package_facts import PackageFacts


@dataclass(frozen=True)
class NamedFiles:
    facts: PackageFacts
    files: PackageFiles

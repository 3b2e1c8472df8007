"""The files of a package beside its facts."""

from __future__ import annotations

from dataclasses import dataclass

from .facts import PackageFacts
from .files import PackageFiles


@dataclass(frozen=True)
class NamedFiles:
    facts: PackageFacts
    files: PackageFiles

"""What earlier runs found in packages, where it still holds."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Set
from typing import Any, Protocol

from ...finding import Finding
from ...package.package_facts import PackageFacts
from ...package.workspace import Workspace
from ..reuse.kept_packages import Observed
from ..suppression.comments import Suppression
from .package_results import PackageResults


class PackageMemory(Protocol):
    """What earlier runs left: on disk for the next process (KeptPackages), or in memory (LivePackages)."""

    def known_facts(self, folders: Iterable[str]) -> dict[str, PackageFacts]: ...

    def unchecked(self) -> frozenset[str]: ...

    def known_results(self, workspace: Workspace, folders: Iterable[str]) -> dict[str, Any]: ...

    def keep(
        self, workspace: Workspace, observed: Mapping[str, Observed], results: Mapping[str, Any], failed: Set[str]
    ) -> None: ...


def to_be_kept(results: PackageResults) -> tuple[object, ...]:
    """Return the parts of the results of a package that are kept; it is one in which nothing crashed."""
    return results.findings, results.suppressions, results.files, results.checksums


def kept_results(
    folder: str, findings: tuple[Finding, ...], suppressions: tuple[Suppression, ...], files: int, checksums: Any
) -> PackageResults:
    """Return the results of a package from the parts that were kept."""
    return PackageResults(folder, findings, (), suppressions, files, checksums)

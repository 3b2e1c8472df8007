"""The version that most packages of a repository have, and the packages with another one."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator

from ...light_dataclasses import dataclass
from ...package.changelog import number_of
from ...package.package_facts import PackageFacts
from ...package.workspace import Workspace
from ...ros.manifest import VERSION


@dataclass(frozen=True)
class VersionMismatch:
    """A package whose version is not that of the others."""

    package: PackageFacts
    common: str
    others: tuple[PackageFacts, ...]
    """Those that have the common version."""


def version_mismatches(workspace: Workspace) -> Iterator[VersionMismatch]:
    """Yield them by repository; the most common version counts, of several the highest, and `0.0.0` only at last."""
    for folders in workspace.repositories:
        packages = [
            facts for facts in workspace.packages if facts.folder in folders and VERSION.fullmatch(facts.version)
        ]
        counted = Counter(facts.version for facts in packages)
        if len(counted) > 1:
            common = max(counted, key=lambda version: (any(number_of(version)), counted[version], number_of(version)))
            others = tuple(facts for facts in packages if facts.version == common)
            yield from (VersionMismatch(facts, common, others) for facts in packages if facts.version != common)

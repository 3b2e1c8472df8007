"""What the rules found in one package: plain values, which go from one process to another."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from contextlib import suppress
from zlib import crc32

from ...files import PackageFiles
from ...finding import Finding
from ...light_dataclasses import dataclass
from ...package.run_events import RuleCrash
from ..suppression.comments import Suppression


@dataclass(frozen=True)
class PackageResults:
    """What the rules found in one package."""

    folder: str
    findings: tuple[Finding, ...] = ()
    crashes: tuple[RuleCrash, ...] = ()
    suppressions: tuple[Suppression, ...] = ()
    files: int = 0
    checksums: tuple[tuple[str, int], ...] = ()
    """Of the files that fixes change, as they were read here; paths from the root of the run."""


def checksums_of(files: PackageFiles, paths: Iterable[str]) -> Iterator[tuple[str, int]]:
    """Yield each of some files (paths from the root of the run) that is there, with the checksum of its bytes."""
    prefix = files.folder + "/" if files.folder else ""
    for path in sorted(paths):
        with suppress(OSError):
            yield path, crc32(files.tree.entry(path.removeprefix(prefix)).data)

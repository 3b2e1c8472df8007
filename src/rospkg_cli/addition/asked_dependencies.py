"""Dependencies that a package was asked for by name: they stay when a node that uses them goes."""

from __future__ import annotations

from collections.abc import Sequence

from ..package.package import Package
from ..scaffold import ScaffoldError
from ..scaffold.answers_record import RECORD, record_in
from .cmake_find import FoundInCMake
from .dependency import AddedDependency
from .part import Part


def without_asked(package: Package, parts: Sequence[Part]) -> Sequence[Part]:
    """Return the parts but for dependencies that the package's record names: `--depends`, `add dependency`."""
    asked = asked_dependencies(package)
    return tuple(p for p in parts if not (isinstance(p, (AddedDependency, FoundInCMake)) and p.name in asked))


def asked_dependencies(package: Package) -> Sequence[str]:
    """Return the dependencies that were asked for; none where no record says so."""
    if not package.files.exists(RECORD):
        return ()
    try:
        return record_in(package.files.readable_text(RECORD).encode(), RECORD).request.depends
    except ScaffoldError:
        return ()

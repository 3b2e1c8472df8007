"""Rule input: what is not known of the install table, without what a fault in setup.py explains."""

from __future__ import annotations

from collections.abc import Iterator

from ..languages.python.lost_commas import lost_commas
from ..languages.python.undefined_names import undefined_names
from ..light_dataclasses import dataclass
from ..package.install_table import InstallTable, UnknownPart
from ..package.setup.setup_py import SetupPy
from ..source import Span


@dataclass(frozen=True)
class UnevaluatedParts:
    table: InstallTable
    setup: SetupPy | None

    @property
    def unexplained(self) -> Iterator[UnknownPart]:
        """What can't be evaluated though nothing is wrong with it; SET308, SET309 and SET310 tell the rest."""
        faults = tuple(told_faults(self.setup)) if self.setup is not None and self.table.unknown else ()
        for part in self.table.unknown:
            is_told = any(part.span.contains(each) for each in faults)
            if self.setup is None or part.path != self.setup.path or not is_told:
                yield part


def told_faults(setup: SetupPy) -> Iterator[Span]:
    """Yield where setup.py stops with an exception, or says something that setuptools passes over."""
    yield from (found.span for found in undefined_names(setup.file))
    yield from (found.span for found in lost_commas(setup.file))
    yield from (found.argument.span for found in setup.misspelt_arguments)

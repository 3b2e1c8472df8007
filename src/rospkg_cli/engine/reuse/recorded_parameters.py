"""The index of declared parameters as one package sees it: the facts that it gives are recorded as others are."""

from __future__ import annotations

from collections.abc import Callable, Iterator

from ...package.package_facts import PackageFacts
from ...package.params.parameter_index import ParameterIndex


class RecordedParameterIndex(ParameterIndex):
    """Answers by the index of the whole workspace: an index for each package would take the square of their number."""

    def __init__(self, real: ParameterIndex, recorded: Callable[[PackageFacts], PackageFacts]) -> None:
        self.real, self.recorded = real, recorded

    def counts(self, names: frozenset[str]) -> Iterator[tuple[PackageFacts, int]]:
        return ((self.recorded(facts), count) for facts, count in self.real.counts(names))

    def count_in(self, folder: str, names: frozenset[str]) -> int:
        return self.real.count_in(folder, names)

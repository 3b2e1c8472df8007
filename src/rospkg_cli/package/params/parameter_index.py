"""The parameters that the packages of a workspace declare, found by name."""

from __future__ import annotations

from collections.abc import Iterable

from ..package_facts import PackageFacts
from .declared_parameter import DeclaredParameter


class ParameterIndex:
    """Declared parameters by the last piece of their names."""

    def __init__(self, packages: Iterable[PackageFacts]) -> None:
        self.by_last: dict[str, list[tuple[PackageFacts, DeclaredParameter]]] = {}
        self._counts: dict[frozenset[str], list[tuple[PackageFacts, int]]] = {}
        self._by_folder: dict[frozenset[str], dict[str, int]] = {}
        for facts in packages:
            for each in facts.parameters:
                self.by_last.setdefault(each.name.rpartition(".")[2], []).append((facts, each))

    def required(self, facts: PackageFacts) -> dict[str, set[str]]:
        """Return, for each source file of a package, the names that it declares without a default."""
        found: dict[str, set[str]] = {}
        for each in facts.parameters:
            if each.required and not each.tail:
                found.setdefault(each.path, set()).add(each.name)
        return found

    def counts(self, names: frozenset[str]) -> Iterable[tuple[PackageFacts, int]]:
        """Return for each package how many of the names it declares, the most first, and by folder among equals."""
        if names not in self._counts:
            self._counts[names] = sorted(self.count(names), key=lambda each: (-each[1], each[0].folder))
        return self._counts[names]

    def count_in(self, folder: str, names: frozenset[str]) -> int:
        """Return how many of the names the package in a folder declares, without a look at all others."""
        if names not in self._by_folder:
            self._by_folder[names] = {facts.folder: count for facts, count in self.counts(names)}
        return self._by_folder[names].get(folder, 0)

    def count(self, names: Iterable[str]) -> list[tuple[PackageFacts, int]]:
        found: dict[str, tuple[PackageFacts, set[str]]] = {}
        for name in names:
            for facts, each in self.by_last.get(name.rpartition(".")[2], ()):
                if each.fits(name):
                    found.setdefault(facts.folder, (facts, set()))[1].add(name)
        return [(facts, len(which)) for facts, which in found.values()]

"""The packages of a workspace by the values of one field of their facts."""

from __future__ import annotations

from functools import cached_property
from typing import Literal

from ..light_dataclasses import dataclass
from .package_facts import PackageFacts

Holders = dict[str | tuple[str, ...], list[PackageFacts]]
"""By a value of one field of their facts, the packages that have it."""

ValuesField = Literal[
    "started_nodes",
    "parsed_yaml",
    "parsed_keys",
    "handed_yaml",
    "interfaces",
    "components",
    "cmake_targets",
    "modules",
    "header_files",
    "included_headers",
    "executables",
    "misplaced_executables",
    "other_markers",
]
"""A field of PackageFacts that is a set of strings, or of tuples of them."""


@dataclass(frozen=True)
class FactsByValue:
    packages: tuple[PackageFacts, ...]

    @cached_property
    def _answers(self) -> dict[tuple[str, ...], tuple[PackageFacts, ...]]:
        return {}

    @cached_property
    def _by_value(self) -> dict[str, Holders]:
        return {}

    def having(self, field: ValuesField, *value: str) -> tuple[PackageFacts, ...]:
        """Return the packages of which a field of their facts holds a value (several strings for a tuple of them)."""
        asked = (field, *value)
        if asked not in self._answers:
            wanted = value[0] if len(value) == 1 else value
            waiting = (facts for facts in self._waiting if facts.may_have(field, value))
            found = [facts for facts in waiting if wanted in getattr(facts, field)]
            every = (*self._holders(field).get(wanted, ()), *found)
            self._answers[asked] = tuple(sorted(every, key=lambda facts: facts.folder))
        return self._answers[asked]

    def _holders(self, field: ValuesField) -> Holders:
        """Return the packages whose facts are collected, by each value of a field."""
        if field not in self._by_value:
            found: Holders = {}
            for facts in self._collected:
                for each in dict.fromkeys(getattr(facts, field)):
                    found.setdefault(each, []).append(facts)
            self._by_value[field] = found
        return self._by_value[field]

    @cached_property
    def _waiting(self) -> tuple[PackageFacts, ...]:
        """The packages of which each fact is collected when it is asked for."""
        return tuple(facts for facts in self.packages if facts.is_on_demand)

    @cached_property
    def _collected(self) -> tuple[PackageFacts, ...]:
        """The other packages, whose facts are all there."""
        return tuple(facts for facts in self.packages if not facts.is_on_demand)

    @cached_property
    def _by_module(self) -> dict[str, str]:
        """By the first name of their modules, the packages whose facts are collected."""
        found: dict[str, str] = {}
        for facts in self._collected:
            for module in facts.modules:
                found.setdefault(module.partition(".")[0], facts.name)
        return found

    @cached_property
    def _installing(self) -> dict[str, str]:
        return {}

    def installing(self, top: str) -> str:
        """Return the first package that installs modules below a name without dots; "" where none does."""
        if top not in self._installing:
            start = f"{top}."
            waiting = (facts for facts in self._waiting if facts.may_have("modules", (top,)))
            found = (each.name for each in waiting if any(f"{name}.".startswith(start) for name in each.modules))
            self._installing[top] = self._by_module.get(top) or next(found, "")
        return self._installing[top]

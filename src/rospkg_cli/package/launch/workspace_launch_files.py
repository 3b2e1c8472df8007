"""The launch files of a workspace, as far as they define launch configurations for each other."""

from __future__ import annotations

from collections.abc import Iterable
from functools import cached_property

from .configuration_events import ConfigurationSummary


class WorkspaceLaunchFiles:
    """Launch files by their name: what one defines for those that it includes, and for the one that includes it."""

    def __init__(self, summaries: Iterable[ConfigurationSummary]) -> None:
        self.by_name: dict[str, list[ConfigurationSummary]] = {}
        self.results: dict[tuple[str, str], frozenset[str] | None] = {}
        """Results so far: every file may include every other."""
        for each in summaries:
            self.by_name.setdefault(each.name, []).append(each)

    @cached_property
    def included(self) -> dict[str, list[ConfigurationSummary]]:
        """The files that include one of a name."""
        found: dict[str, list[ConfigurationSummary]] = {}
        for each in (summary for several in self.by_name.values() for summary in several):
            for name in each.includes:
                found.setdefault(name, []).append(each)
        return found

    def has(self, configuration: str, besides: str = "") -> bool:
        """Return whether any file, but for those of one name, defines a launch configuration of a name."""
        others = (several for name, several in self.by_name.items() if name != besides)
        return any(configuration in each.defines for several in others for each in several)

    def inherited(self, name: str) -> frozenset[str] | None:
        """Return what is defined by files that include a file of this name; None where that is unknown."""
        if ("inherited", name) not in self.results:
            self.results["inherited", name] = self.all_inherited(name)
        return self.results["inherited", name]

    def defined_by(self, name: str) -> frozenset[str] | None:
        """Return what files of this name define, also by what they include; None where that is unknown."""
        if ("defined", name) not in self.results:
            self.results["defined", name] = self.all_defined_by(name)
        return self.results["defined", name]

    def all_inherited(self, name: str) -> frozenset[str] | None:
        names: set[str] = set()
        seen, queue = {name}, [name]
        while queue:
            for each in self.included.get(queue.pop(), ()):
                if each.may_define_others or each.uses_undefined:
                    return None
                names |= each.defines
                if each.name not in seen:
                    seen.add(each.name)
                    queue.append(each.name)
        return frozenset(names)

    def all_defined_by(self, name: str) -> frozenset[str] | None:
        names: set[str] = set()
        seen, queue = {name}, [name]
        while queue:
            found = self.by_name.get(queue.pop())
            if not found or any(each.may_define_others for each in found):
                return None
            for each in found:
                names |= each.defines
                queue += each.includes - seen
                seen |= each.includes
        return frozenset(names)

"""Everything that is known about the packages around the one that is checked."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

from .facts import PackageFacts


@dataclass(frozen=True)
class Workspace:
    packages: tuple[PackageFacts, ...] = ()
    """Of all packages found, sorted by folder."""
    given: frozenset[str] = frozenset()
    """The folders of those that the user asked about."""
    complete: bool = True
    """False where a `.repos` file says that more belongs here: then an unknown name can't be told."""
    prefix_names: frozenset[str] = frozenset()
    """Names found in AMENT_PREFIX_PATH and /opt/ros: they may silence a finding, never cause one."""

    @cached_property
    def _by_name(self) -> dict[str, PackageFacts]:
        return {facts.name: facts for facts in reversed(self.packages)}

    @cached_property
    def _by_folder(self) -> dict[str, PackageFacts]:
        return {facts.folder: facts for facts in self.packages}

    @property
    def names(self) -> frozenset[str]:
        return frozenset(self._by_name)

    def named(self, name: str) -> PackageFacts | None:
        return self._by_name.get(name)

    def at(self, folder: str) -> PackageFacts:
        """Return the facts of the package in a folder; raises KeyError."""
        return self._by_folder[folder]

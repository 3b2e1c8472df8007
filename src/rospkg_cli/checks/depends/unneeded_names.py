"""Why an unknown name stops no build here: rosdep skips it, its repository is cloned, or a list of rosdep's has it."""

from __future__ import annotations

from functools import cached_property

from ...light_dataclasses import dataclass
from .declared_dependencies import DeclaredDependencies

SKIPPED = "; a page or a script here has rosdep skip it"

CLONED = "; a repository of that name is cloned here, and may have it"


@dataclass(frozen=True)
class UnneededNames:
    declared: DeclaredDependencies

    def is_skipped(self, name: str) -> bool:
        """Return whether a page or a script here has rosdep skip a name."""
        return name in self.skipped

    def why(self, name: str, *, may_be_key: bool) -> str:
        """Return why a name stops no build here, as the end of a message; "" where nothing says so."""
        if self.is_skipped(name):
            return SKIPPED
        from .fetched_repositories import FetchedRepositories  # a clean package needs none
        from .own_rosdep_lists import OwnRosdepLists

        declared = self.declared
        if FetchedRepositories(declared.release.files, declared.workspace, declared.otherwise.hidden).has_cloned(name):
            return CLONED
        return OwnRosdepLists(declared).may_have(name) if may_be_key else ""

    @cached_property
    def skipped(self) -> frozenset[str]:
        """The names that pages and scripts have rosdep skip."""
        from .skipped_keys import skipped_keys  # a clean package needs none

        return skipped_keys(self.declared.release.files)

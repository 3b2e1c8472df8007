"""How a repository has an undeclared dependency installed in other ways than by the package's own package.xml."""

from __future__ import annotations

from collections.abc import Iterable
from functools import cached_property
from typing import TYPE_CHECKING

from ...light_dataclasses import dataclass
from ...package.package_facts import PackageFacts
from ...package.workspace import Workspace
from ..repository.older_distribution import OlderDistribution
from ..repository.released import Release
from .repository_dependencies import brought_in, is_declared_by_others
from .system_installs import SystemInstalls

if TYPE_CHECKING:
    from .hidden_packages import HiddenPackages


@dataclass(frozen=True)
class InstalledOtherwise:
    facts: PackageFacts
    workspace: Workspace
    release: Release

    def is_declared_by_others(self, names: Iterable[str]) -> bool:
        """Return whether other packages of the repository declare one of some names, or their dependencies bring it."""
        names = [*names]
        here = next((each for each in self.workspace.repositories if self.facts.folder in each), None)
        if any(is_declared_by_others(name, self.facts, here, self.workspace) for name in names):
            return True
        return not brought_in(here, self.workspace).keys().isdisjoint(names)

    def is_lacked_by_releases(self, names: Iterable[str]) -> bool:
        """Return whether one of some names is missing only where the package is installed alone, as from a release.

        Elsewhere rosdep installs what any package of the repository declares. Packages of the workspace don't count:
        `colcon build --packages-up-to` builds one only where it is declared.
        """
        names = [*names]
        return not any(map(self.workspace.named, names)) and self.is_declared_by_others(names)

    def is_by_command(self, names: Iterable[str]) -> bool:
        """Return whether the repository installs one of some names by lists or commands of its own.

        Whoever installs a release does not run these, so they don't count where releases are made.
        """
        return self.installs.has(names) and not self.release.is_made

    @cached_property
    def installs(self) -> SystemInstalls:
        return SystemInstalls(self.release.files, self.workspace)

    @cached_property
    def distribution(self) -> OlderDistribution:
        """The distributions that the repository names."""
        return OlderDistribution(self.release.files)

    @cached_property
    def hidden(self) -> HiddenPackages:
        """The packages in folders that colcon ignores; imported only where a name is unknown."""
        from .hidden_packages import HiddenPackages

        return HiddenPackages(self.release.files, self.workspace)

"""Names of plugins that no plugin description of the workspace has (PLG003)."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cached_property

from ...light_dataclasses import dataclass
from ...package.package_facts import PackageFacts
from ...package.plugin import Plugin, PluginUse
from ...package.workspace import Workspace
from ...ros.names import NameKind
from ...suggest import near_names
from .described_names import DescribedNames
from .exported_classes import tail
from .plugin_names import SEPARATOR, are_related, is_brought, is_something_else, plain
from .plugin_uses import uses
from .well_known_plugins import WellKnownPlugins, WrongPlugin

BUILT_IN = frozenset({"rviz_common"})
"""Packages with plugins that are registered without a description."""


@dataclass(frozen=True)
class UnknownPlugin:
    user: PackageFacts
    use: PluginUse
    owner: PackageFacts
    """The package that describes the suggested plugin, or should describe this one."""
    suggestion: Plugin | None
    is_guess: bool = False
    """Whether only the class is the same: a package outside the workspace may have a plugin of this name."""


@dataclass(frozen=True)
class PluginReferences:
    workspace: Workspace

    @cached_property
    def described(self) -> DescribedNames:
        return DescribedNames(self.workspace)

    def misspelt(self) -> Iterator[WrongPlugin]:
        """Yield the misspelt names of plugins of well-known packages, which are not in the workspace."""
        return WellKnownPlugins(self.described).misspelt()

    def unknown(self) -> Iterator[UnknownPlugin]:
        """Yield the unknown names in the linted packages.

        Where a linted package describes plugins, also those in other packages that name plugins of a linted one.
        """
        describe = any(facts.plugins for facts in self.described.selected)
        for user, use in uses(self.workspace.packages if describe else self.described.selected, self.workspace):
            if self.is_of_interest(user, use) and not self.described.is_described(use.name):
                yield from self.problems_of(user, use)

    def is_of_interest(self, user: PackageFacts, use: PluginUse) -> bool:
        """Return whether a use concerns a linted package: its user, the package of the name, or one with this class."""
        if user.folder in self.workspace.selected:
            return True
        owner = self.workspace.named(SEPARATOR.split(use.name)[0])
        return tail(use.name) in self.own_tails if owner is None else owner.folder in self.workspace.selected

    @cached_property
    def own_tails(self) -> frozenset[str]:
        """The classes of the plugins of the linted packages."""
        return frozenset(tail(plugin.name) for facts in self.described.selected for plugin in facts.plugins)

    def problems_of(self, user: PackageFacts, use: PluginUse) -> Iterator[UnknownPlugin]:
        """Yield a use of a name that no description has, if its package is known, or one plugin has the same class."""
        name = SEPARATOR.split(use.name)[0]
        owner = self.workspace.named(name)
        if owner is not None:
            if self.is_certain(owner) and not is_something_else(owner, use.name):
                yield UnknownPlugin(user, use, owner, self.suggestion(owner, use))
        elif self.is_nowhere(name) and not is_brought(use.name, user):
            named = self.described.with_word(tail(use.name))
            alike = [each for each in named if tail(each[1].name) == tail(use.name) and may_be_loaded(each[1], use)]
            if len(alike) == 1:
                is_guess = not are_related(name, SEPARATOR.split(alike[0][1].name)[0])
                yield UnknownPlugin(user, use, *alike[0], is_guess)

    def is_nowhere(self, package: str) -> bool:
        """Return whether there is certainly no package of a name."""
        known = self.workspace.is_available(package) or self.workspace.kind_of(package) in (
            NameKind.PACKAGE,
            NameKind.KEY,
        )
        return self.workspace.is_complete and not known and not self.workspace.may_lack(package)

    def is_certain(self, owner: PackageFacts) -> bool:
        """Return whether a package has plugins in C++, and all of them are known."""
        cpp = any("_py::" not in plugin.base for plugin in owner.plugins)
        return cpp and owner.is_ament and owner.knows("plugins") and owner.name not in BUILT_IN

    def suggestion(self, owner: PackageFacts, use: PluginUse) -> Plugin | None:
        """Return the one plugin of a package with the same class, or else with a similar one; None for several."""
        plugins = [each for each in owner.plugins if may_be_loaded(each, use)]
        alike = [each for each in plugins if plain(each.name) == plain(use.name)]
        if not alike:
            nearby = near_names(tail(use.name), [tail(each.name) for each in plugins])
            alike = [each for each in plugins if tail(each.name) in nearby]
        return alike[0] if len(alike) == 1 else None


def may_be_loaded(plugin: Plugin, use: PluginUse) -> bool:
    """Return whether a plugin is of the kind that RViz loads at a place; always so for places outside of RViz."""
    return not use.kind or tail(plugin.base) == use.kind

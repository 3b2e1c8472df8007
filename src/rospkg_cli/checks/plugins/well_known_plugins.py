"""Misspelt or removed names of plugins of well-known packages that are not in the workspace (PLG003)."""

from __future__ import annotations

import re
from collections.abc import Iterator

from ...light_dataclasses import dataclass, replace
from ...package.package_facts import PackageFacts
from ...package.plugin import PluginUse
from ...package.workspace import Workspace
from ...ros.names import NameKind
from ...ros.rviz_plugins import kind_of
from ...ros.well_known import WrongName, plugins_of_class, wrong_plugin
from ...suggest import near_names
from .described_names import DescribedNames
from .plugin_names import SEPARATOR
from .plugin_uses import uses


@dataclass(frozen=True)
class WrongPlugin:
    """A use of a name that no plugin of a well-known package has."""

    user: PackageFacts
    use: PluginUse
    wrong: WrongName
    is_guess: bool = False
    """Whether only the class is known: another package, outside the workspace, may have a plugin of this name."""


@dataclass(frozen=True)
class WellKnownPlugins:
    described: DescribedNames

    @property
    def workspace(self) -> Workspace:
        return self.described.workspace

    def misspelt(self) -> Iterator[WrongPlugin]:
        """Yield the names in the linted packages that no plugin has of the well-known package they begin with.

        Names of packages that are in the workspace are left to `PluginReferences`.
        """
        for user, use in uses(self.described.selected, self.workspace):
            first = SEPARATOR.split(use.name)[0]
            is_here = self.workspace.named(first) is not None or self.described.is_owned(first)
            if is_here or self.described.is_described(use.name):
                continue
            wrong = wrong_plugin(use.name)
            if wrong is not None:
                is_other = bool(use.kind and wrong.better) and kind_of(wrong.better) != use.kind
                yield WrongPlugin(user, use, replace(wrong, better="") if is_other else wrong)
            elif not self.is_known(user, first, use.name):
                yield from self.slips(user, use)

    def is_known(self, user: PackageFacts, first: str, name: str) -> bool:
        """Return whether the first word of a name is a known package, a dependency of the user, or the user itself."""
        is_package = self.workspace.kind_of(first) in (NameKind.PACKAGE, NameKind.KEY)
        return is_package or first in (user.name, name) or first in {each.name for each in user.dependencies}

    def slips(self, user: PackageFacts, use: PluginUse) -> Iterator[WrongPlugin]:
        """Yield a name whose package is misspelt, with the name of the plugin that was probably intended.

        That is the same plugin of a dependency with a similar name, or else the only well-known plugin of this class.
        """
        first, rest = SEPARATOR.split(use.name)[0], use.name.partition("/")[2]
        names = near_names(first, {each.name for each in user.dependencies}, 1)
        near = [each for each in names if re.sub(r"\d", "", each) != re.sub(r"\d", "", first)]
        if rest and len(near) == 1:
            yield WrongPlugin(user, use, WrongName(f"{near[0]}/{rest}", False), is_guess=use.is_plain_type)
            return
        same = plugins_of_class(use.name)
        found = [each for each in same if ("::" in each) == ("::" in use.name)] or same
        if len(found) == 1:
            whole = SEPARATOR.split(found[0])[0]
            is_part = whole.startswith(f"{first}_") or bool(near_names(first, {whole}, 1))
            yield WrongPlugin(user, use, WrongName(found[0], False), is_guess=not is_part)

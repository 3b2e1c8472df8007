"""References to plugins that no plugin description has."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from functools import cached_property

from ...light_dataclasses import dataclass, replace
from ...package.file_role import role_of
from ...package.package_facts import PackageFacts, Plugin, PluginUse
from ...package.urdf.robot_words import may_be_made
from ...package.workspace import Workspace
from ...ros.names import NameKind
from ...ros.rviz_plugins import kind_of
from ...ros.well_known import WrongName, plugins_of_class, wrong_plugin
from ...suggest import near_names
from ..yaml_elsewhere import is_named_yaml
from .exported_classes import tail
from .plugin_names import SEPARATOR, are_related, is_brought, is_something_else, plain

YAML, ROBOTS = (".yaml", ".yml"), (".urdf", ".xacro")
BY_MOVEIT = frozenset({"ros2_controllers.yaml", "moveit_controllers.yaml"})
"""What moveit_configs_utils opens by its usual name."""
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
    """Whether only the class is the same: a package that is not here may have the plugin of that first name."""


@dataclass(frozen=True)
class WrongPlugin:
    """A name that no plugin of a well-known package has."""

    user: PackageFacts
    use: PluginUse
    wrong: WrongName
    is_guess: bool = False
    """Whether only the class is known: a package that is not here may describe plugins of that first name."""


@dataclass(frozen=True)
class PluginReferences:
    workspace: Workspace

    @cached_property
    def _by_word(self) -> dict[str, list[tuple[PackageFacts, Plugin]]]:
        return {}

    def with_word(self, word: str) -> list[tuple[PackageFacts, Plugin]]:
        """Return the plugins in whose names a word stands, with their packages; of several of one name the last."""
        if word not in self._by_word:
            packages = (facts for facts in self.workspace.packages if facts.may_have("plugins", (word,)))
            found = {each.name: (facts, each) for facts in packages for each in facts.plugins if word in each.name}
            self._by_word[word] = list(found.values())
        return self._by_word[word]

    def is_described(self, name: str) -> bool:
        return any(plugin.name == name for _, plugin in self.with_word(tail(name)))

    @cached_property
    def selected(self) -> list[PackageFacts]:
        return [facts for facts in self.workspace.packages if facts.folder in self.workspace.selected]

    def unknown(self) -> Iterator[UnknownPlugin]:
        """Yield the unknown names in the selected packages.

        In all where one of those describes plugins itself; there only what is about a package of theirs.
        """
        describe = any(facts.plugins for facts in self.selected)
        for user, use in uses(self.workspace.packages if describe else self.selected, self.workspace):
            if self.is_of_interest(user, use) and not self.is_described(use.name):
                yield from self.problems_of(user, use)

    def is_of_interest(self, user: PackageFacts, use: PluginUse) -> bool:
        """Return whether a user is selected, or the package that a name begins with; else what its class may be of."""
        if user.folder in self.workspace.selected:
            return True
        owner = self.workspace.named(SEPARATOR.split(use.name)[0])
        return tail(use.name) in self.own_tails if owner is None else owner.folder in self.workspace.selected

    @cached_property
    def own_tails(self) -> frozenset[str]:
        """The classes of the plugins of the selected packages."""
        return frozenset(tail(plugin.name) for facts in self.selected for plugin in facts.plugins)

    def misspelt(self) -> Iterator[WrongPlugin]:
        """Yield the names that begin as those of a well-known package, which is not here, and that it does not have.

        Of the selected packages.
        """
        for user, use in uses(self.selected, self.workspace):
            first = SEPARATOR.split(use.name)[0]
            is_here = self.workspace.named(first) is not None or self.is_owned(first)
            if is_here or self.is_described(use.name):
                continue
            wrong = wrong_plugin(use.name)
            if wrong is not None:
                is_other = bool(use.kind and wrong.better) and kind_of(wrong.better) != use.kind
                yield WrongPlugin(user, use, replace(wrong, better="") if is_other else wrong)
            elif not self.is_known(user, first, use.name):
                yield from self.slips(user, use)

    def is_known(self, user: PackageFacts, first: str, name: str) -> bool:
        """Return whether the first name of a plugin is that of a package, or the user's own."""
        is_package = self.workspace.kind_of(first) in (NameKind.PACKAGE, NameKind.KEY)
        return is_package or first in (user.name, name) or first in {each.name for each in user.dependencies}

    def slips(self, user: PackageFacts, use: PluginUse) -> Iterator[WrongPlugin]:
        """Yield the name of a plugin with the package that its user depends on, where only that one is near.

        Else that of the only well-known plugin of the class whose package is near, or has all words of the first name.
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

    def is_owned(self, first: str) -> bool:
        """Return whether the name of a described plugin begins with a piece."""
        return any(SEPARATOR.split(plugin.name)[0] == first for _, plugin in self.with_word(first))

    def problems_of(self, user: PackageFacts, use: PluginUse) -> Iterator[UnknownPlugin]:
        name = SEPARATOR.split(use.name)[0]
        owner = self.workspace.named(name)
        if owner is not None:
            if self.is_certain(owner) and not is_something_else(owner, use.name):
                yield UnknownPlugin(user, use, owner, self.suggestion(owner, use))
        elif self.is_nowhere(name) and not is_brought(use.name, user):
            named = self.with_word(tail(use.name))
            alike = [each for each in named if tail(each[1].name) == tail(use.name) and may_be_loaded(each[1], use)]
            if len(alike) == 1:
                is_guess = not are_related(name, SEPARATOR.split(alike[0][1].name)[0])
                yield UnknownPlugin(user, use, *alike[0], is_guess)

    def is_nowhere(self, package: str) -> bool:
        """Return whether there certainly is no such package."""
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
        """Return the plugin of a package with the same class, or with nearly that name; None where there are more."""
        plugins = [each for each in owner.plugins if may_be_loaded(each, use)]
        alike = [each for each in plugins if plain(each.name) == plain(use.name)]
        if not alike:
            nearby = near_names(tail(use.name), [tail(each.name) for each in plugins])
            alike = [each for each in plugins if tail(each.name) in nearby]
        return alike[0] if len(alike) == 1 else None


def uses(packages: Iterable[PackageFacts], workspace: Workspace) -> Iterator[tuple[PackageFacts, PluginUse]]:
    """Yield the uses of plugins, each with its package; tests may name one that is not there on purpose.

    In a file that nothing opens no list is read; a panel that RViz lacks is a blank one, and nothing else is lost.
    """
    for user in packages:
        for use in user.plugin_uses if user.build_type != "catkin" else ():
            if role_of(use.path) != "test":
                is_met = use.kind != "Panel" and is_opened(use.path, user, workspace)
                yield user, use if is_met else replace(use, is_listed=False)


def is_opened(path: str, user: PackageFacts, workspace: Workspace) -> bool:
    """Return whether anything may open a file: YAML and robots are named where there are launch files.

    What MoveIt opens by its usual name is not.
    """
    name = path.rpartition("/")[2]
    if not path.endswith((*YAML, *ROBOTS)) or name in BY_MOVEIT:
        return True
    if not any(facts.launch_files for facts in workspace.packages):
        return True
    if path.endswith(YAML):
        return is_named_yaml(path, user, workspace)
    texts = (words for facts in workspace.packages for words in facts.robot_words)
    return any(name in words or may_be_made(name, words) for words in texts)


def may_be_loaded(plugin: Plugin, use: PluginUse) -> bool:
    """Return whether a plugin is of the kind that RViz loads at a place; all are where that is of none."""
    return not use.kind or tail(plugin.base) == use.kind

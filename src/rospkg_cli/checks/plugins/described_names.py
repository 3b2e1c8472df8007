"""Rule input: the plugins that the packages of a workspace describe, by the words of their names."""

from __future__ import annotations

from functools import cached_property

from ...light_dataclasses import dataclass
from ...package.package_facts import PackageFacts
from ...package.plugin import Plugin
from ...package.workspace import Workspace
from .exported_classes import tail
from .plugin_names import SEPARATOR


@dataclass(frozen=True)
class DescribedNames:
    workspace: Workspace

    @cached_property
    def _by_word(self) -> dict[str, list[tuple[PackageFacts, Plugin]]]:
        return {}

    def with_word(self, word: str) -> list[tuple[PackageFacts, Plugin]]:
        """Return the plugins whose names contain a word, with their packages; of several of one name the last."""
        if word not in self._by_word:
            packages = (facts for facts in self.workspace.packages if facts.may_have("plugins", (word,)))
            found = {each.name: (facts, each) for facts in packages for each in facts.plugins if word in each.name}
            self._by_word[word] = list(found.values())
        return self._by_word[word]

    def is_described(self, name: str) -> bool:
        """Return whether a package describes a plugin of exactly this name."""
        return any(plugin.name == name for _, plugin in self.with_word(tail(name)))

    @cached_property
    def selected(self) -> list[PackageFacts]:
        """The packages that are linted."""
        return [facts for facts in self.workspace.packages if facts.folder in self.workspace.selected]

    def is_owned(self, first: str) -> bool:
        """Return whether the name of a described plugin begins with a word, as with the name of its package."""
        return any(SEPARATOR.split(plugin.name)[0] == first for _, plugin in self.with_word(first))

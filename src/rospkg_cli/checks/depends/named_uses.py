"""Packages that leave a certain trace wherever they are used: controllers by their types, commands by their calls."""

from __future__ import annotations

import re

from ...light_dataclasses import dataclass
from ...package.workspace import Workspace
from ...ros.read_table import rows
from .word_index import WordIndex

CONTROLLERS, BASE = "ros2_controllers", "controller_interface::"
"""The metapackage of released controllers, and where the base classes of all of them are."""

COMMANDS = frozenset({
    "ros2action", "ros2bag", "ros2component", "ros2interface", "ros2lifecycle", "ros2multicast", "ros2node",
    "ros2param", "ros2service", "ros2topic",
})  # fmt: skip
"""Commands of ros2cli, each in a package of its own: `ros2 topic` is in `ros2topic`."""


@dataclass(frozen=True)
class NamedUses:
    words: WordIndex
    workspace: Workspace

    def is_unused(self, name: str) -> bool:
        """Return whether a package that is needed to run would be named, and is not."""
        if self.holds_controllers(name):
            return not self.words.has(name) and not self.is_loaded(name)
        return name in COMMANDS and not self.words.has(name) and not self.is_called(name)

    def holds_controllers(self, name: str) -> bool:
        """Return whether all that a package has is loaded as `name/Class` by ros2_control's controller manager."""
        facts = self.workspace.named(name)
        if facts is None:
            return name in rows("metapackages.txt")[CONTROLLERS] and not name.startswith("rqt_")
        return bool(facts.plugins) and not facts.executables and all(p.base.startswith(BASE) for p in facts.plugins)

    def is_loaded(self, package: str) -> bool:
        """Return whether parameters of any package of the workspace name one of its plugins."""
        start = (f"{package}/", f"{package}::")
        return any(use.name.startswith(start) for facts in self.workspace.packages for use in facts.plugin_uses)

    def is_called(self, package: str) -> bool:
        """Return whether a text holds the command, as one string or as a list of words."""
        command = re.compile(rf"\bros2[\s'\",\[\]]+{package.removeprefix('ros2')}\b")
        return any(command.search(text) for texts in self.words.by_purpose.values() for text in texts)

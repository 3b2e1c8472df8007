"""Levels and messages of exported classes that no plugin description has (PLG002)."""

from __future__ import annotations

import re
from collections.abc import Sequence

from ...languages.cpp.file import CppFile
from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...package.workspace import Workspace
from ..enumeration import in_ticks
from ..fault import Level
from .exported_classes import ExportedClass, tail
from .named_plugins import NamedPlugins
from .plugin_package import PluginPackage

OTHER_LOADERS = regex(r"\bclass_loader::(?:MultiLibrary)?ClassLoader\b")
"""A loader that takes a library by its path, and its classes by the names in the macros."""
NAME = regex(r"[A-Za-z_]\w{0,200}")


@dataclass(frozen=True)
class UndescribedClasses:
    package: PluginPackage
    workspace: Workspace
    named: NamedPlugins

    def is_described_elsewhere(self, exported: ExportedClass) -> bool:
        """Return whether another package of the workspace describes a class of this one."""
        others = (facts for facts in self.workspace.packages if facts.folder != self.package.facts.folder)
        return any(plugin.type == exported.type for facts in others for plugin in facts.plugins)

    def level(self, exported: ExportedClass) -> tuple[Level, str]:
        """Return the level of an exported class that no description has, and why it is an info, if it is one."""
        if any(OTHER_LOADERS.search(file.source.text) for file in self.package.sources):
            return "info", "; class_loader, which this package uses, needs no description"
        names = (exported.type, f"{self.package.facts.name}/{tail(exported.type)}")
        level, why = self.named.level(names, exported.base)
        return ("info", why) if level == "info" else ("warning", "")

    def message(self, exported: Sequence[ExportedClass]) -> str:
        """Return the message of exported classes that no description has."""
        first, *others = exported
        are, they, them = ("are", "they", "them") if others else ("is", "it", "it")
        types = in_ticks(each.type for each in exported)
        line = f'<class type="{first.type}" base_class_type="{first.base}">'
        return (
            f"{types} {are} exported here, and no plugin description has {them}: {they} can't be loaded by name; add "
            f"`{line}` to one, or remove the macro"
        )

    def message_of_base(self, exported: ExportedClass, derived: str) -> str:
        """Return the message of an exported class that no description has, and another one derives from."""
        return (
            f"`{exported.type}` is exported here, and no plugin description has it: it can't be loaded by name; "
            f"remove the macro, if it is only there as the base of `{derived}`"
        )

    def derived(self, exported: ExportedClass) -> str:
        """Return another exported class that derives from one; "" where none does."""
        base = tail(exported.type)
        others = (each.type for each in self.package.exported if each.type != exported.type)
        return next((each for each in others if any(derives(f, tail(each), base) for f in self.package.sources)), "")


def derives(file: CppFile, name: str, base: str) -> bool:
    """Return whether a file defines a class that derives from another one, both by their plain names."""
    named = NAME.fullmatch(name) and NAME.fullmatch(base)
    head = rf"\b(?:class|struct)\s+(?:\w+\s+)?{name}\b[^{{;]{{0,500}}:[^{{;]{{0,500}}\b{base}\b"
    return bool(named) and re.search(head, file.source.text) is not None

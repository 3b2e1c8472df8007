"""What helps a described plugin that no source exports, and an exported class that no description has."""

from __future__ import annotations

import re

from ...languages.cpp.file import CppFile
from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...package.workspace import Workspace
from ..fault import Level
from .exported_classes import ExportedClass, tail
from .plugin_package import DescribedPlugin, PluginPackage

NAME = regex(r"[A-Za-z_]\w{0,200}")


@dataclass(frozen=True)
class PluginExports:
    package: PluginPackage
    workspace: Workspace

    def advice(self, entry: DescribedPlugin) -> str:
        """Return what helps: the class may be nowhere, in a source that nothing compiles, or lack the macro."""
        macro = f"add `PLUGINLIB_EXPORT_CLASS({entry.type}, {entry.plugin.base.value})`"
        defining = [file.path for file in self.package.sources if defines(file, tail(entry.type))]
        if not defining:
            others = self.of_that_name(entry)
            return f"nothing here defines the class: remove it here{f' (there is `{others[0]}`)' if others else ''}"
        source = next((path for path in defining if not path.endswith((".h", ".hpp", ".hh"))), "")
        if source and not self.package.compiled.targets_of(source):
            return f"{macro} to `{source}`, which no target compiles, and compile it into the library"
        return f"{macro} to its source, or remove it here"

    def of_that_name(self, entry: DescribedPlugin) -> list[str]:
        """Return the described plugins of other packages whose class has the same name."""
        others = (facts for facts in self.workspace.packages if facts.folder != self.package.facts.folder)
        every = (plugin for facts in others for plugin in facts.plugins)
        return [plugin.name for plugin in every if tail(plugin.type) == tail(entry.type)]

    def undescribed(self, exported: ExportedClass) -> tuple[str, Level]:
        """Return the message and the level of an exported class that no description has."""
        start = f"`{exported.type}` is exported here, and no plugin description has it: it can't be loaded by name"
        if derived := self.derived(exported):
            return f"{start}; remove the macro, if it is only there as the base of `{derived}`", "info"
        line = f'<class type="{exported.type}" base_class_type="{exported.base}">'
        return f"{start}; add `{line}` to one, or remove the macro", "warning"

    def derived(self, exported: ExportedClass) -> str:
        """Return another exported class that derives from one; "" where none does."""
        base = tail(exported.type)
        others = (each.type for each in self.package.exported if each.type != exported.type)
        return next((each for each in others if any(derives(f, tail(each), base) for f in self.package.sources)), "")


def defines(file: CppFile, name: str) -> bool:
    """Return whether a file has the class, or members of it."""
    pattern = rf"\b(?:class|struct)\s+(?:\w+\s+)?{name}\b|\b{name}::"
    return bool(NAME.fullmatch(name)) and re.search(pattern, file.source.text) is not None


def derives(file: CppFile, name: str, base: str) -> bool:
    named = NAME.fullmatch(name) and NAME.fullmatch(base)
    head = rf"\b(?:class|struct)\s+(?:\w+\s+)?{name}\b[^{{;]{{0,500}}:[^{{;]{{0,500}}\b{base}\b"
    return bool(named) and re.search(head, file.source.text) is not None

"""Levels and messages of described plugins that no source exports (PLG002)."""

from __future__ import annotations

import re
from collections.abc import Sequence

from ...languages.cpp.file import CppFile
from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...package.plugins.description import PluginClass
from ...package.workspace import Workspace
from ..enumeration import in_ticks
from ..fault import WORST_FIRST, Level
from .compiled_files import HEADERS, is_compiled
from .exported_classes import ExportedClass, tail
from .named_plugins import NamedPlugins
from .plugin_package import DescribedPlugin, PluginPackage

NAME = regex(r"[A-Za-z_]\w{0,200}")


@dataclass(frozen=True)
class PluginExports:
    package: PluginPackage
    workspace: Workspace
    named: NamedPlugins

    def weighed(self, message: str, level: Level, plugins: Sequence[PluginClass]) -> tuple[str, Level]:
        """Return a message and its level, which is lower where nothing loads any of the plugins by its name."""
        most, why = self.named.worst(plugins)
        return f"{message}{why}", max(level, most, key=WORST_FIRST.index)

    def advice(self, entry: DescribedPlugin) -> tuple[str, Level]:
        """Return the message and the level of a class that no source exports.

        It may lack the macro, or be in a source that nothing compiles.
        """
        start = f"no source exports `{entry.type}`: loading the plugin `{entry.plugin.lookup_name}` fails"
        macro = f"add `PLUGINLIB_EXPORT_CLASS({entry.type}, {entry.plugin.base.value})`"
        sources = (path for path in self.defining(entry) if not path.endswith(HEADERS))
        source = next(sources, "")
        if source and not self.is_compiled(source):
            return f"{start}; {macro} to `{source}`, which no target compiles, and compile it in", "warning"
        return f"{start}; {macro} to its source, or remove it here", "error"

    def unneeded(self, entry: DescribedPlugin) -> str:
        """Return the message of a class that is described and only a node of behavior trees; "" of all others."""
        source = self.named.tree_node(entry.plugin)
        return source and (
            f"no source exports `{entry.type}`: loading the plugin `{entry.plugin.lookup_name}` fails; `{source}` "
            "registers it for behavior trees, which need no description: remove it here"
        )

    def defining(self, entry: DescribedPlugin) -> list[str]:
        """Return the sources that have the class of an entry."""
        return [file.path for file in self.package.sources if defines(file, tail(entry.type))]

    def is_nowhere(self, entry: DescribedPlugin) -> bool:
        """Return whether nothing of the package exports or defines the class of an entry, or one like it."""
        return self.package.suggestion(entry) is None and not self.defining(entry)

    def undefined(self, entries: Sequence[DescribedPlugin]) -> tuple[str, Level]:
        """Return the message and the level of entries whose classes the package does not have.

        A library of a package that it depends on may have them, once the process has loaded that library.
        """
        types, names = in_ticks(each.type for each in entries), in_ticks(each.plugin.lookup_name for each in entries)
        plugins, classes, them = ("plugins", "the classes", "them") if entries[1:] else ("plugin", "the class", "it")
        others = self.of_that_name(entries[0])
        there = f" (there is `{others[0]}`)" if others else ""
        level: Level = "warning" if self.linked else "error"
        but = f", unless `{self.linked[0]}` has {them}" if self.linked else ""
        message = (
            f"no source exports {types}: loading the {plugins} {names} fails; nothing here defines {classes}: remove "
            f"{them} here{but}{there}"
        )
        if self.package.exported and not self.named.is_asked([each.plugin for each in entries]):
            return f"{message}; nothing here names {them}", "info"
        if not any(map(self.package.libraries.target, {each.library for each in entries})):
            return f"{message}; no target here makes the library, another package may", "info"
        return self.weighed(message, level, [each.plugin for each in entries])

    @property
    def linked(self) -> list[str]:
        """The packages of the workspace with libraries that this one depends on."""
        named = (self.workspace.named(each.name) for each in self.package.facts.dependencies)
        return [facts.name for facts in named if facts is not None and facts.is_compiled]

    def uncompiled(self, entry: DescribedPlugin, exported: ExportedClass) -> str:
        """Return the message of an entry whose class a source exports that no target compiles; "" of others."""
        if self.is_compiled(exported.path):
            return ""
        return (
            f"no target compiles `{exported.path}`, which exports `{exported.type}`: loading the plugin "
            f"`{entry.plugin.lookup_name}` fails; compile it into the library, and write `{exported.type}` here"
        )

    def is_compiled(self, source: str) -> bool:
        return is_compiled(self.package.libraries.compiled, self.package.sources, source)

    def of_that_name(self, entry: DescribedPlugin) -> list[str]:
        """Return the described plugins of other packages whose class has the same name."""
        others = (facts for facts in self.workspace.packages if facts.folder != self.package.facts.folder)
        every = (plugin for facts in others for plugin in facts.plugins)
        return [plugin.name for plugin in every if tail(plugin.type) == tail(entry.type)]


def defines(file: CppFile, name: str) -> bool:
    """Return whether a file has the class, or members of it."""
    pattern = rf"\b(?:class|struct)\s+(?:\w+\s+)?{name}\b|\b{name}::"
    return bool(NAME.fullmatch(name)) and re.search(pattern, file.source.text) is not None

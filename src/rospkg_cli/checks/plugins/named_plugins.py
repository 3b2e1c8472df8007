"""Rule input: whether anything here loads a plugin of the package by its name, so that its faults matter."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterable, Iterator
from functools import cached_property

from ...files import PackageFiles
from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...package.file_role import is_set_aside, role_of
from ...package.launch.live_text import live_text
from ...package.package_facts import PackageFacts
from ...package.plugins.description import PluginClass
from ...package.workspace import Workspace
from ...ros.plugins import LOADED_WHOLE, OFFERED
from ..fault import WORST_FIRST, Level
from ..made_classes import MadeClasses
from ..repository.pages_and_scripts import pages_and_scripts

COMPILED = (".cpp", ".cc", ".cxx", ".hpp", ".h")
TEXTS = (".py", ".launch", ".xml", ".yaml", ".yml", ".json", ".urdf", ".xacro", ".srdf", ".rviz", ".perspective")
DESCRIPTION = "base_class_type"
QUOTED = regex(r'"[^"\\\n]+"')


@dataclass(frozen=True)
class NamedPlugins:
    files: PackageFiles
    package: PackageFacts
    workspace: Workspace
    made: MadeClasses | None = None

    def level(self, names: Collection[str], base: str) -> tuple[Level, str]:
        """Return the highest level for a plugin that can't be loaded, and why it is no error.

        The names are those that may refer to it: the one in its description, and its class.
        """
        if self.is_named(names) or base.startswith(LOADED_WHOLE):
            return "error", ""
        if any(is_in(text, names) for text in self.pages):
            return "warning", "; only a page names it"
        sibling = self.named_sibling(names)
        if sibling and not base.startswith(OFFERED):
            return "info", f"; nothing here names it, as it does `{sibling}`"
        if not sibling and self.is_base_loaded(base):
            return "error", ""
        if maker := next(filter(None, map(self.made.maker, sorted(names))), "") if self.made is not None else "":
            return "info", f"; nothing here names it, and `{maker}` makes it itself"
        return "warning", "; nothing here names it, others may"

    def tree_node(self, plugin: PluginClass) -> str:
        """Return the source that registers a class as a node of behavior trees; "" where it may be loaded as a plugin.

        A behavior tree gets it from the library itself, which its program loads by name.
        """
        if self.made is None or self.is_asked([plugin]) or self.is_base_loaded(plugin.base.value):
            return ""
        return self.made.registering(plugin.type.value)

    def is_asked(self, plugins: Iterable[PluginClass]) -> bool:
        """Return whether anything names one of some plugins, or shows or loads all of their kind."""
        texts = (*self.texts, *self.pages)
        return any(
            each.base.value.startswith((*LOADED_WHOLE, *OFFERED))
            or not self.used.isdisjoint(each.names)
            or any(is_in(text, each.names) for text in texts)
            for each in plugins
        )

    def worst(self, plugins: Iterable[PluginClass]) -> tuple[Level, str]:
        """Return the highest level of some plugins that share a fault."""
        found = [self.level(each.names, each.base.value) for each in plugins]
        level, why = min(found, key=lambda each: WORST_FIRST.index(each[0]))
        return level, why.replace("names it", "names them") if found[1:] else why

    def is_named(self, names: Collection[str]) -> bool:
        """Return whether parameters, robots, views, code or launch files name a plugin; tests do not count."""
        return not self.used.isdisjoint(names) or any(is_in(text, names) for text in self.texts)

    def named_sibling(self, names: Collection[str]) -> str:
        """Return another plugin of the package that something names; "" where nothing does."""
        others = (each.name for each in self.package.plugins if each.name not in names)
        return next((each for each in others if self.is_named([each])), "")

    def is_base_loaded(self, base: str) -> bool:
        """Return whether a package here has a loader of a base class: what it loads may be put together."""
        return any(base == each for facts in self.workspace.packages for _, each in facts.loaders)

    @cached_property
    def used(self) -> frozenset[str]:
        uses = (each for facts in self.workspace.packages for each in facts.plugin_uses if each.is_listed)
        return frozenset(each.name for each in uses if role_of(each.path) != "test" and not is_set_aside(each.path))

    @cached_property
    def pages(self) -> tuple[str, ...]:
        return pages_and_scripts(self.files)

    @cached_property
    def texts(self) -> tuple[str, ...]:
        return tuple(self._texts())

    def _texts(self) -> Iterator[str]:
        for path in self.files.paths:
            if path == "package.xml" or role_of(path) in ("test", "aside") or is_set_aside(path):
                continue
            if path.endswith(COMPILED):
                yield " ".join(QUOTED.findall(self.files.readable_text(path)))
            elif path.endswith(TEXTS) and DESCRIPTION not in (text := live_text(self.files, path)):
                yield text


def is_in(text: str, names: Collection[str]) -> bool:
    """Return whether a text has one of some names; one that is a plain word counts where it is a value."""
    return any(name in text and pattern(name).search(text) is not None for name in names if name)


def pattern(name: str) -> re.Pattern[str]:
    word = re.escape(name)
    if "/" in name or ":" in name:
        return re.compile(rf"(?<![\w/:.-]){word}(?![\w/:-])")
    return re.compile(rf"(?m)[\"'>]{word}[\"'<]|[:\[,-][ ]*{word}[ ]*(?:[\],]|$)")

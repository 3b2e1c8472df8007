"""Base classes of plugins: the package that a description is exported to, and the name that is loaded.

pluginlib compares texts: the package of the ament index entry with the first argument of the ClassLoader, and
`base_class_type` with its second.
"""

from __future__ import annotations

from collections.abc import Iterator

from ...light_dataclasses import dataclass
from ...package.package_facts import PackageFacts
from ...package.plugins.description import DescriptionExport, PluginClass, PluginDescription
from ...package.plugins.loaders import PluginLoaders
from ...package.workspace import Workspace
from ...ros.names import NameKind
from ...suggest import near_names
from .exported_classes import spaceless
from .named_plugins import NamedPlugins
from .plugin_package import PluginPackage
from .unmatched_loaders import UnmatchedLoader, unmatched_loaders


@dataclass(frozen=True)
class WrongBaseExport:
    """A description that is exported to a package for which no ClassLoader looks."""

    description: PluginDescription
    exported: DescriptionExport
    base: str
    """The base class that is loaded for another package; "" where only the package is unknown."""
    owners: tuple[str, ...]
    """The packages that it is loaded from."""


@dataclass(frozen=True)
class WrongBaseClass:
    """A class whose base class no ClassLoader loads under that name."""

    description: PluginDescription
    plugin: PluginClass
    suggestion: str
    is_of_macro: bool = False
    """Whether the macro of the class has the other base."""


@dataclass(frozen=True)
class PluginBases:
    package: PluginPackage | None
    loaders: PluginLoaders
    named: NamedPlugins
    facts: PackageFacts
    workspace: Workspace

    def described(self) -> Iterator[tuple[PluginDescription, tuple[PluginClass, ...]]]:
        """Yield the descriptions that CMake exports, with the classes that a source exports."""
        if self.package is None:
            return
        without_source = {entry.plugin.element.span for entry in self.package.without_source()}
        for description in self.package.descriptions:
            if description.is_indexed:
                cpp = [
                    each
                    for each in description.classes
                    if not each.is_python and each.element.span not in without_source
                ]
                yield description, tuple(cpp)

    def misplaced(self) -> Iterator[WrongBaseExport]:
        for description, classes in self.described():
            owners = {each.base.value: self.workspace.loaders_of(each.base.value) for each in classes}
            for exported in description.exported:
                serves = any(exported.base in packages or not packages for packages in owners.values())
                if not exported.is_indexed:
                    continue
                if owners and not serves and self.is_certain(exported.base):
                    base, packages = next(iter(owners.items()))
                    yield WrongBaseExport(description, exported, base, tuple(sorted(packages)))
                elif self.workspace.kind_of(exported.base) is NameKind.UNKNOWN:
                    yield WrongBaseExport(description, exported, "", ())

    def is_certain(self, package: str) -> bool:
        """Return whether all that a package may load is known: it is none, or every loader around is known."""
        if not self.workspace.is_available(package) and self.workspace.kind_of(package) is not NameKind.PACKAGE:
            return True
        around = self.workspace.named(package) is not None
        return around and all(facts.knows("loaders") for facts in self.workspace.packages)

    def misnamed(self) -> Iterator[WrongBaseClass]:
        """Yield the classes whose base class is not loaded, but a similar one is."""
        for description, classes in self.described():
            known = {base for package in description.bases for base in self.workspace.bases_loaded_from(package)}
            for plugin in classes:
                if (base := self.other_arguments(plugin)) is not None:
                    yield WrongBaseClass(description, plugin, base, True)
                elif not self.workspace.loaders_of(plugin.base.value):
                    suggestion = self.base_in_source(plugin, known) or misspelt(plugin.base.value, known)
                    of_macro = misspelt(plugin.base.value, self.bases_in_source(plugin)) if suggestion is None else None
                    if base_class := suggestion or of_macro:
                        yield WrongBaseClass(description, plugin, base_class, of_macro is not None)

    def other_arguments(self, plugin: PluginClass) -> str | None:
        """Return the base of the macro of a class, where it is of the same template, with other arguments."""
        bases = self.bases_in_source(plugin)
        if len(bases) != 1 or not plugin.base.value.endswith(">"):
            return None
        (base,) = bases
        own, other = (text.partition("<") for text in (spaceless(plugin.base.value), spaceless(base)))
        return base if own[0] == other[0] and last_word(own[2]) != last_word(other[2]) else None

    def base_in_source(self, plugin: PluginClass, known: set[str]) -> str | None:
        """Return the base class in the export macro, where that one is loaded."""
        bases = self.bases_in_source(plugin)
        return bases.pop() if len(bases) == 1 and bases <= known else None

    def bases_in_source(self, plugin: PluginClass) -> set[str]:
        """Return the base classes that macros export a class with."""
        exported = self.package.exported if self.package is not None else ()
        return {each.base for each in exported if spaceless(each.type) == spaceless(plugin.type.value)}

    def unmatched_loaders(self) -> Iterator[UnmatchedLoader]:
        """Yield the class loaders of the package that name a package which does not exist."""
        return unmatched_loaders(self.loaders, self.facts, self.workspace)


def last_word(arguments: str) -> str:
    return arguments.rstrip("> ").rpartition("::")[2]


def misspelt(base: str, known: set[str]) -> str | None:
    """Return the only class of the same namespace with a similar name; None where there is none, or several."""
    space, _, name = base.rpartition("::")
    names = [each.rpartition("::")[2] for each in known if each.rpartition("::")[0] == space]
    found = near_names(name, names)
    return f"{space}::{found[0]}" if len(found) == 1 else None

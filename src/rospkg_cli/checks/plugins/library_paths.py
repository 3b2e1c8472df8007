"""The library path of a plugin description, and what is wrong with it."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import PurePosixPath
from typing import Literal

from ...languages.xml.parser import Attribute
from ...light_dataclasses import dataclass
from ...package.cmake.cmake_project import CMake
from ...package.install_table import InstallTable
from ...suggest import near_names
from ..cmake.target_references import TargetReferences
from ..fault import Level
from .exported_classes import spaceless
from .named_plugins import NamedPlugins
from .plugin_package import DescribedPlugin, PluginPackage

LibraryFault = Literal["prefixed", "unknown", "static", "absent"]
SUFFIXES = (".so", ".dylib", ".dll", ".a")


@dataclass(frozen=True)
class WrongLibraryPath:
    entry: DescribedPlugin
    """The first class of the library."""
    path: Attribute
    fault: LibraryFault
    suggestion: str = ""
    """The path that it should be, as far as there is one; the target that is not installed."""
    is_certain: bool = False
    """Whether that is the library which the class is compiled into."""


@dataclass(frozen=True)
class PluginLibraries:
    package: PluginPackage
    table: InstallTable
    named: NamedPlugins

    @property
    def cmake(self) -> CMake:
        return self.package.cmake

    def level(self, wrong: WrongLibraryPath) -> tuple[Level, str]:
        """Return the level of a library that can't be loaded, by what loads its classes, and why it is no error."""
        if wrong.fault == "prefixed":
            return "warning", ""
        library = wrong.entry.plugin.library
        classes = [each.plugin for each in self.package.entries if each.plugin.library is library]
        return self.named.worst(classes)

    def wrong(self) -> Iterator[WrongLibraryPath]:
        """Yield each wrong library once, without those of classes that no source exports."""
        without_source = {entry.plugin.element.span for entry in self.package.without_source()}
        seen = set()
        for entry in self.package.entries:
            key = (entry.description.file, entry.plugin.library.span)
            if key not in seen and entry.plugin.element.span not in without_source and entry.plugin.path is not None:
                seen.add(key)
                yield from self.problems_of(entry, entry.plugin.path)

    def problems_of(self, entry: DescribedPlugin, path: Attribute) -> Iterator[WrongLibraryPath]:
        name = path.value.strip()
        target = self.package.libraries.target(name)
        if target is None:
            if self.package.libraries.are_known(name):
                yield WrongLibraryPath(entry, path, "unknown", *self.suggestion(entry, name))
        elif (
            "/" not in name
            and name.startswith("lib")
            and self.package.libraries.target(name[3:]) == target
            and not self.is_made(name)
        ):
            yield WrongLibraryPath(entry, path, "prefixed", name[3:], True)
        elif self.is_static(target):
            yield WrongLibraryPath(entry, path, "static", target)
        elif self.is_uninstalled(entry, target):
            yield WrongLibraryPath(entry, path, "absent", target)

    def is_made(self, name: str) -> bool:
        """Return whether a library has exactly this name."""
        return self.cmake.target(name) is not None or name in self.cmake.output_names.values()

    def is_static(self, target: str) -> bool:
        library = self.cmake.target(target)
        return library is not None and "STATIC" in library.options

    def suggestion(self, entry: DescribedPlugin, name: str) -> tuple[str, bool]:
        """Return the library that holds the class, else the one whose name is hidden in a path or a file name."""
        makers = [e for e in self.package.exported if spaceless(e.type) == spaceless(entry.type)]
        homes = {home for each in makers for home in self.package.libraries.of_source(each.path)}
        if len(homes) == 1:
            home = homes.pop()
            return self.cmake.output_names.get(home, home), True
        stem = PurePosixPath(name).name
        for suffix in SUFFIXES:
            stem = stem.removesuffix(suffix)
        for each in (stem, stem.removeprefix("lib")):
            if self.package.libraries.target(each) is not None and self.is_made(each):
                return each, each in homes
        return "", False

    def is_uninstalled(self, entry: DescribedPlugin, target: str) -> bool:
        """Return whether a library that is not only there for tests is certainly not installed."""
        library = self.cmake.target(target)
        if library is None or library.call.testing or library.call.maybe or not self.table.knows("library"):
            return False
        if all(each.testing for each in entry.description.exported if each.is_indexed):
            return False
        if any(f":{target}>" in word.text for rule in self.cmake.installs for word in rule.items):
            return False
        if any(near_names(each.word.text, [target]) for each in TargetReferences(self.cmake).broken()):
            return False  # a rule installs it under a misspelt name, which CMK110 reports
        name = self.cmake.output_names.get(target, target)
        files = {PurePosixPath(row.destination).name.partition(".")[0].removeprefix("lib") for row in self.table.rows}
        return name.removeprefix("lib") not in files

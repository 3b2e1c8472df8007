"""The plugins of one package: what its descriptions list, and what its sources export."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cached_property

from ...files import PackageFiles
from ...languages.cpp.file import CppFile
from ...languages.cpp.read import SUFFIXES
from ...light_dataclasses import dataclass
from ...package.cmake.cmake_project import CMake
from ...package.cmake.intended_paths import intended_paths
from ...package.file_role import role_of
from ...package.package_facts import PackageFacts
from ...package.plugins.description import PluginClass, PluginDescription
from .described_libraries import DescribedLibraries
from .exported_classes import (
    ExportedClass,
    exported_classes,
    is_plain,
    is_registered_otherwise,
    spaceless,
    tail,
    wraps_export,
)

COMPONENTS = frozenset({"rclcpp::Node", "rclcpp_components::NodeFactory"})
"""Base classes of components: class_loader registers these, and no plugin description lists them."""


@dataclass(frozen=True)
class DescribedPlugin:
    """A class of a description that pluginlib can find."""

    description: PluginDescription
    plugin: PluginClass

    @property
    def type(self) -> str:
        return self.plugin.type.value

    @property
    def library(self) -> str:
        path = self.plugin.path
        return "" if path is None else path.value


@dataclass(frozen=True)
class PluginPackage:
    facts: PackageFacts
    files: PackageFiles
    cmake: CMake
    sources: tuple[CppFile, ...]
    descriptions: tuple[PluginDescription, ...]

    @cached_property
    def libraries(self) -> DescribedLibraries:
        return DescribedLibraries(self.files, self.cmake)

    @cached_property
    def exported(self) -> tuple[ExportedClass, ...]:
        return tuple(exported_classes(self.sources))

    @cached_property
    def _types(self) -> frozenset[str]:
        return frozenset(spaceless(each.type) for each in self.exported)

    @cached_property
    def entries(self) -> tuple[DescribedPlugin, ...]:
        """The C++ plugins of the descriptions that CMake exports, in order; none for ROS 1."""
        if not self.facts.is_ament:
            return ()
        return tuple(
            DescribedPlugin(description, plugin)
            for description in self.descriptions
            if description.is_indexed
            for plugin in description.classes
            if not plugin.is_python
        )

    @cached_property
    def is_readable(self) -> bool:
        """Whether all sources could be read, and all CMake files could be evaluated."""
        paths = sum(path.endswith(SUFFIXES) for path in self.files.paths)
        return self.cmake.is_complete and len(self.sources) == paths

    def without_source(self) -> Iterator[DescribedPlugin]:
        """Yield the described plugins whose class no source exports.

        There is none where that is not known: where a macro of the package wraps the export macro of pluginlib.
        """
        if self.is_readable and not any(map(wraps_export, self.sources)):
            for entry in self.entries:
                exported = spaceless(entry.type) in self._types
                if not exported and self.is_own(entry) and not is_registered_otherwise(self.sources, entry.type):
                    yield entry

    def is_own(self, entry: DescribedPlugin) -> bool:
        """Return whether all sources of the library of an entry are known, or no target builds it."""
        target = self.libraries.target(entry.library)
        if target is not None:
            return self.libraries.compiled.is_complete(target)
        return self.libraries.are_known(entry.library)

    @cached_property
    def _described(self) -> dict[str, list[PluginDescription]]:
        """By class, the descriptions that have it, exported or not."""
        found: dict[str, list[PluginDescription]] = {}
        for description in self.descriptions:
            for plugin in description.classes:
                found.setdefault(spaceless(plugin.type.value), []).append(description)
        return found

    @cached_property
    def compiled_exports(self) -> tuple[ExportedClass, ...]:
        """The exported classes whose source is certainly compiled into a library that is no test."""
        if not self.facts.is_ament:
            return ()
        return tuple(
            each
            for each in self.exported
            if not each.is_conditional
            and role_of(each.path) == "run"
            and is_plain(each.type)
            and self.libraries.of_source(each.path)
        )

    def undescribed(self) -> Iterator[ExportedClass]:
        """Yield the exported classes that no description names, of libraries with plugins."""
        libraries = {self.libraries.target(entry.library) for entry in self.entries}
        suggested = {found.type for entry in self.without_source() if (found := self.suggestion(entry)) is not None}
        for each in self.compiled_exports:
            for_plugins = not self.entries or libraries.intersection(self.libraries.of_source(each.path))
            if each.base in COMPONENTS:
                continue
            if for_plugins and spaceless(each.type) not in self._described and each.type not in suggested:
                yield each

    def unexported(self) -> Iterator[tuple[PluginDescription, ExportedClass]]:
        """Yield the descriptions that CMake does not export, with the first class that pluginlib can't find for it."""
        from ...package.plugins.other_exports import may_export  # few packages have plugins

        seen = set()
        for each in self.compiled_exports:
            descriptions = self._described.get(spaceless(each.type), ())
            found = any(description.is_indexed or description.is_for_rqt for description in descriptions)
            for description in () if found else descriptions:
                if description.file not in seen and description.file not in intended_paths(self.cmake):
                    seen.add(description.file)
                    if not may_export(self.cmake, description.file):
                        yield description, each

    def suggestion(self, entry: DescribedPlugin) -> ExportedClass | None:
        """Return the one exported class that an entry probably refers to; None where there is none, or several.

        It has no entry of its own, and the same name, or else the same base class and library.
        """
        free = [each for each in self.exported if spaceless(each.type) not in self._described]
        alike = [each for each in free if tail(each.type) == tail(entry.type)]
        if not alike:
            library, base = self.libraries.target(entry.library), tail(entry.plugin.base.value)
            alike = [e for e in free if library in self.libraries.of_source(e.path) and tail(e.base) == base]
        return alike[0] if len({each.type for each in alike}) == 1 else None

"""The plugins of one package: what its descriptions list, and what its sources export."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cached_property

from ...files import PackageFiles
from ...languages.cmake.values import UNKNOWN
from ...languages.cpp.file import CppFile
from ...languages.cpp.read import SUFFIXES
from ...light_dataclasses import dataclass
from ...package.cmake.cmake_project import CMake
from ...package.cmake.meant_paths import meant_paths
from ...package.file_role import role_of
from ...package.package_facts import PackageFacts
from ...package.plugins.description import PluginClass, PluginDescription
from ..cmake.source_targets import SourceTargets
from .exported_classes import (
    ExportedClass,
    exported_classes,
    is_plain,
    is_registered_otherwise,
    tail,
    wraps_export,
)

PREBUILT = (".so", ".a", ".dylib", ".dll")
COMPONENTS = frozenset({"rclcpp::Node", "rclcpp_components::NodeFactory"})
"""What class_loader registers of them is a component, which no plugin description has."""
FETCHES = frozenset({"externalproject_add", "fetchcontent_declare", "fetchcontent_makeavailable", "ament_vendor"})


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
    def compiled(self) -> SourceTargets:
        return SourceTargets(self.cmake)

    @cached_property
    def exported(self) -> tuple[ExportedClass, ...]:
        return tuple(exported_classes(self.sources))

    @cached_property
    def _types(self) -> frozenset[str]:
        return frozenset(spaceless(each.type) for each in self.exported)

    @cached_property
    def entries(self) -> tuple[DescribedPlugin, ...]:
        """What CMake exports and what is C++, in order; nothing of ROS 1, where package.xml does that."""
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
        """Whether all sources could be read, and CMake could be followed."""
        paths = sum(path.endswith(SUFFIXES) for path in self.files.paths)
        return self.cmake.is_complete and len(self.sources) == paths

    def without_source(self) -> Iterator[DescribedPlugin]:
        """Yield the described plugins whose class no source exports, as far as that is known.

        What a macro exports that the package defines of pluginlib's is not.
        """
        if self.is_readable and not any(map(wraps_export, self.sources)):
            for entry in self.entries:
                exported = spaceless(entry.type) in self._types
                if not exported and self.is_own(entry) and not is_registered_otherwise(self.sources, entry.type):
                    yield entry

    def is_own(self, entry: DescribedPlugin) -> bool:
        """Return whether the library of an entry is made of sources that can be seen, or of nothing that is known."""
        target = self.library(entry.library)
        if target is not None:
            return self.compiled.is_complete(target)
        return self.sees_all_libraries(entry.library)

    def sees_all_libraries(self, name: str) -> bool:
        """Return whether every library that may have a name is known: made by CMake, of a known name."""
        fetched = any(call.name in FETCHES for call in self.cmake.calls)
        known = all(each.word.is_known for each in self.cmake.targets if each.is_library)
        known = known and not any(UNKNOWN in new for new in self.cmake.output_names.values())
        return self.cmake.is_complete and known and not fetched and not self.prebuilt.intersection(stems(name))

    @cached_property
    def prebuilt(self) -> frozenset[str]:
        """The names of the library files in the package, without `lib`."""
        names = (path.rpartition("/")[2] for path in self.files.paths if path.endswith(PREBUILT) or ".so." in path)
        return frozenset(name.partition(".")[0].removeprefix("lib") for name in names)

    def library(self, name: str) -> str | None:
        """Return the target that makes the library of a description's path; None where none is known to."""
        named = {new: target for target, new in self.cmake.output_names.items() if UNKNOWN not in new}
        for stem in stems(name):
            target = self.cmake.target(named.get(stem, stem))
            if target is not None and target.is_library:
                return target.name
        return None

    @cached_property
    def _described(self) -> dict[str, list[PluginDescription]]:
        """Class → the descriptions that have it, exported or not."""
        found: dict[str, list[PluginDescription]] = {}
        for description in self.descriptions:
            for plugin in description.classes:
                found.setdefault(spaceless(plugin.type.value), []).append(description)
        return found

    @cached_property
    def compiled_exports(self) -> tuple[ExportedClass, ...]:
        """The exported classes of sources that certainly go into a library that is installed for use."""
        if not self.facts.is_ament:
            return ()
        return tuple(
            each
            for each in self.exported
            if not each.is_conditional
            and role_of(each.path) == "run"
            and is_plain(each.type)
            and self.libraries_of(each)
        )

    def undescribed(self) -> Iterator[ExportedClass]:
        """Yield the exported classes that no description names, of libraries that are there for plugins."""
        libraries = {self.library(entry.library) for entry in self.entries}
        suggested = {found.type for entry in self.without_source() if (found := self.suggestion(entry)) is not None}
        for each in self.compiled_exports:
            for_plugins = not self.entries or libraries.intersection(self.libraries_of(each))
            if each.base in COMPONENTS:
                continue
            if for_plugins and spaceless(each.type) not in self._described and each.type not in suggested:
                yield each

    def unexported(self) -> Iterator[tuple[PluginDescription, ExportedClass]]:
        """Yield the descriptions that CMake does not export, with the first class that so can't be found."""
        from ...package.plugins.other_exports import may_export  # few packages have plugins

        seen = set()
        for each in self.compiled_exports:
            descriptions = self._described.get(spaceless(each.type), ())
            found = any(description.is_indexed or description.is_for_rqt for description in descriptions)
            for description in () if found else descriptions:
                if description.file not in seen and description.file not in meant_paths(self.cmake):
                    seen.add(description.file)
                    if not may_export(self.cmake, description.file):
                        yield description, each

    def libraries_of(self, exported: ExportedClass) -> list[str]:
        """Return the libraries that the source of an exported class is compiled into, under any build option."""
        names = sorted(self.compiled.targets_of(exported.path))
        targets = [self.cmake.target(name) for name in names]
        return [
            each.name
            for each in targets
            if each is not None and each.is_library and not each.call.testing and not each.call.maybe
        ]

    def suggestion(self, entry: DescribedPlugin) -> ExportedClass | None:
        """Return the one exported class without an entry that an entry may mean: of its name, or its base and library.

        None where there is none, or more than one.
        """
        free = [each for each in self.exported if spaceless(each.type) not in self._described]
        alike = [each for each in free if tail(each.type) == tail(entry.type)]
        if not alike:
            library, base = self.library(entry.library), tail(entry.plugin.base.value)
            alike = [each for each in free if library in self.libraries_of(each) and tail(each.base) == base]
        return alike[0] if len({each.type for each in alike}) == 1 else None


def spaceless(name: str) -> str:
    return "".join(name.split())


def stems(path: str) -> tuple[str, ...]:
    """Return the names that the library of a description's path may have, as pluginlib looks for it.

    These are the path as it is, without `lib`, and without its folders.
    """
    names = (path, path[3:] if path.startswith("lib") else path, path.rpartition("/")[2])
    return tuple(dict.fromkeys(names))

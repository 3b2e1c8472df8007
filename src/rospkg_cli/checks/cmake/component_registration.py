"""Components: what CMake registers against what the sources register."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cached_property
from typing import Literal

from ...languages.cmake.evaluated_command import path_in_package
from ...languages.cmake.values import BINARY, UNKNOWN
from ...languages.cpp.file import CppFile
from ...light_dataclasses import dataclass
from ...package.cmake.cmake_package import CMakePackage
from ...package.cmake.components import Component
from ...package.cmake.foreign_commands import names_for_macros
from ...suggest import nearest, slips
from .component_libraries import ComponentLibraries
from .registered_classes import RegisteredClass, has_own_macro, registered_classes
from .target_references import TargetReferences

INDEX = "rclcpp_components"
"""The part of the resource index in which classes are registered, which a package may fill by itself."""


@dataclass(frozen=True)
class ComponentRegistration:
    package: CMakePackage
    sources: tuple[CppFile, ...]

    @cached_property
    def in_sources(self) -> tuple[RegisteredClass, ...]:
        return registered_classes(self.sources)

    @cached_property
    def libraries(self) -> ComponentLibraries:
        return ComponentLibraries(self.package.cmake)

    @property
    def generated(self) -> bool:
        """Whether some sources of a target are generated, unknown or not there."""
        cmake = self.package.cmake
        targets = [t for each in cmake.components if (t := cmake.target(each.target.text)) is not None]
        if any(not word.is_known or word.text.startswith(BINARY) for target in targets for word in target.sources):
            return True
        paths = [path_in_package(word.text, target.call.folder) for target in targets for word in target.sources]
        return any(path is None or cmake.package_files.absent.is_expected(path) for path in paths)

    def sure(self) -> Iterator[Component]:
        """Yield the components that CMake certainly registers."""
        for component in self.package.cmake.components:
            words = (component.target, component.plugin)
            if all(word.is_known and not word.maybe for word in words) and not component.call.maybe:
                yield component

    def without_target(self) -> Iterator[Component]:
        """Yield the components of a target that does not exist."""
        references = TargetReferences(self.package.cmake)
        cmake = self.package.cmake
        for component in self.sure() if cmake.is_complete else ():
            name = component.target.text
            is_known = not cmake.reads_unknown_files or bool(slips(name, references.names))
            if name not in references.names and UNKNOWN not in references.names and is_known:
                yield component

    def without_source(self) -> Iterator[Component]:
        """Yield the components whose class no source registers under that name."""
        if has_own_macro(self.sources) or self.generated or self.package.cmake.reads_unknown_files:
            return
        names = {each.name for each in self.in_sources}
        seen: set[str] = set()
        for component in self.sure():
            if component.plugin.text not in names and component.plugin.text not in seen:
                seen.add(component.plugin.text)
                yield component

    @cached_property
    def misspelt(self) -> frozenset[str]:
        """The classes that sources register and CMake names nearly so."""
        registered = [each.name for each in self.in_sources]
        near = (nearest(component.plugin.text, registered) for component in self.without_source())
        return frozenset(name for name in near if name is not None)

    def without_cmake(self) -> Iterator[RegisteredClass]:
        """Yield the classes that a source of a target registers and no call of CMake does."""
        cmake = self.package.cmake
        if not cmake.is_complete or cmake.reads_unknown_files or any(not c.plugin.is_known for c in cmake.components):
            return
        names = {component.plugin.text for component in cmake.components}
        indexed = " ".join(text for call in cmake.calls if INDEX in call.texts for text in call.texts)
        for each in self.in_sources if f"resource_index/{INDEX}" not in self.written else ():
            is_named = each.name in names | self.misspelt or each.name in indexed
            is_built = each.path in self.libraries.loaded | self.libraries.linked
            if not is_named and is_built and each.name not in self.handed_on:
                yield each

    @cached_property
    def handed_on(self) -> frozenset[str]:
        """The words that macros of other packages are given: a class among them may be registered there."""
        return names_for_macros(self.package.cmake)

    @cached_property
    def written(self) -> str:
        return " ".join(file.source.text for file in self.package.cmake.files)

    def harm(self, found: RegisteredClass) -> Literal["error", "warning", "info"]:
        """Return how bad it is that CMake does not register a class: a launch file of the package may load it."""
        facts = self.package.facts
        if (facts.name, found.name) in facts.loaded_components:
            return "error"
        return "info" if found.path in self.libraries.linked else "warning"

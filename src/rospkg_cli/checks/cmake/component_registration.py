"""Components: what CMake registers against what the sources register."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from functools import cached_property
from typing import Literal

from ...languages.cmake.evaluated_command import path_in_package
from ...languages.cmake.targets import Target
from ...languages.cmake.values import BINARY, UNKNOWN
from ...languages.cpp.call import CppArgument
from ...languages.cpp.file import CppFile
from ...light_dataclasses import dataclass
from ...package.cmake.cmake_package import CMakePackage
from ...package.cmake.components import Component
from ...package.cmake.target_links import TargetLinks
from ...source import Span
from ...suggest import nearest, slips
from .target_references import TargetReferences

INDEX = "rclcpp_components"
"""The part of the resource index in which classes are registered, which a package may fill by itself."""
MACRO = "RCLCPP_COMPONENTS_REGISTER_NODE"


@dataclass(frozen=True)
class RegisteredClass:
    """`RCLCPP_COMPONENTS_REGISTER_NODE(ns::Class)` in a file."""

    name: str
    path: str
    span: Span

    @property
    def unregistered(self) -> str:
        start = f"`{self.name}` is registered here and by no `rclcpp_components_register_node(…)`"
        return f"{start}: it can't be loaded by its name; register it in CMakeLists.txt too"


@dataclass(frozen=True)
class ComponentRegistration:
    package: CMakePackage
    sources: tuple[CppFile, ...]

    @cached_property
    def in_sources(self) -> tuple[RegisteredClass, ...]:
        found = []
        for file in self.sources:
            for call in file.calls_to(MACRO):
                for argument in (call.arguments or ())[:1]:
                    found.append(RegisteredClass(name_of(argument), file.path, argument.span))
        return tuple(found)

    @property
    def macros(self) -> bool:
        """Whether a macro of the package's own registers classes: then it is unknown which."""
        bodies = [define.body for file in self.sources for define in file.defines]
        is_in_macro = any(MACRO in body or "CLASS_LOADER_REGISTER" in body for body in bodies)
        return is_in_macro or any(True for file in self.sources for _ in file.calls_to("CLASS_LOADER_REGISTER_CLASS"))

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
        if self.macros or self.generated or self.package.cmake.reads_unknown_files:
            return
        names = {each.name for each in self.in_sources}
        seen: set[str] = set()
        for component in self.sure():
            if component.plugin.text not in names and component.plugin.text not in seen:
                seen.add(component.plugin.text)
                yield component

    @cached_property
    def misspelt(self) -> frozenset[str]:
        """The classes that sources register and CMake calls by a name near theirs."""
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
            if not is_named and each.path in self.in_libraries | self.in_linked_libraries:
                yield each

    @cached_property
    def written(self) -> str:
        return " ".join(file.source.text for file in self.package.cmake.files)

    def harm(self, found: RegisteredClass) -> Literal["error", "warning", "info"]:
        """Return how bad it is that CMake does not register a class: a launch file of the package may load it."""
        facts = self.package.facts
        if (facts.name, found.name) in facts.loaded_components:
            return "error"
        return "info" if found.path in self.in_linked_libraries else "warning"

    @cached_property
    def in_libraries(self) -> frozenset[str]:
        """The sources of the libraries that components are registered of, and of those that nothing links."""
        cmake = self.package.cmake
        names = {component.target.text for component in cmake.components}
        targets = [target for name in names if (target := cmake.target(name)) is not None]
        links = TargetLinks(cmake)
        return sources_of([*targets, *(each for each in self.installed_libraries if not links.with_word(each.name))])

    @cached_property
    def in_linked_libraries(self) -> frozenset[str]:
        """The sources of libraries that something of the package links: a program may make nodes of their classes."""
        return sources_of(self.installed_libraries) - self.in_libraries

    @cached_property
    def installed_libraries(self) -> tuple[Target, ...]:
        """The libraries that are certainly installed and not static."""
        installed = TargetLinks(self.package.cmake).installed
        return tuple(
            each
            for each in self.package.cmake.targets
            if each.is_library and each.is_built and each.name in installed
            if not (each.call.maybe or each.call.testing or each.options & {"STATIC"})
        )


def sources_of(targets: Iterable[Target]) -> frozenset[str]:
    return frozenset(p for t in targets for w in t.sources if (p := path_in_package(w.text, t.call.folder)))


def name_of(argument: CppArgument) -> str:
    return "".join(argument.text.split())

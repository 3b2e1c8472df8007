"""Sets of targets that `install(TARGETS … EXPORT set)` fills and that nothing exports to other packages."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cached_property
from typing import Annotated

from ...languages.cmake.evaluated_command import EvaluatedCommand, path_in_package
from ...languages.cmake.targets import Target
from ...languages.cmake.values import UNKNOWN, Word
from ...languages.cpp.file import CppFile
from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...package.cmake.cmake_package import CMakePackage
from ...package.cmake.foreign_commands import foreign_commands
from ...package.cmake.needed_files import PARAMETERS
from ...package.plugins.description import PluginDescription
from ...unreadable import READABLE
from .missing_export_dependencies import REGISTERS
from .named_targets import EXPORTS
from .target_references import TargetReferences

LOADED = regex(r"ADD_PLUGIN|REGISTER_\w*PLUGIN|EXPORT_\w*CLASS|REGISTER_\w*CLASS|REGISTER_NODE|PYBIND11_MODULE")
"""Macros that make a plugin, which nothing links, of a library."""
DEFINITION = "BT_PLUGIN_EXPORT"
DEFINES = "target_compile_definitions"


@dataclass(frozen=True)
class UnexportedSet:
    word: Word
    """The name of the set, where it is first filled."""
    library: str
    """The first library in it, as others would link it."""
    is_exported_otherwise: bool
    """Whether libraries are exported without targets, by `ament_export_libraries`."""
    is_built: bool
    """Whether one of them has code; one of headers alone is not missed where the include directory is exported."""


@dataclass(frozen=True)
class UnexportedTargets:
    package: CMakePackage
    sources: tuple[CppFile, ...]
    descriptions: Annotated[tuple[PluginDescription, ...], READABLE]

    def all(self) -> Iterator[UnexportedSet]:
        """Yield each set with a library that others may link, once; nothing where any command may hand it on."""
        cmake = self.package.cmake
        is_clear = cmake.is_complete and not cmake.reads_unknown_files and cmake.ends_a_package
        if not self.package.is_ament or not is_clear or next(foreign_commands(cmake), None) is not None:
            return
        named = set(self.named())
        if UNKNOWN in named or any(each.kind == "export" for each in TargetReferences(cmake).broken()):
            return  # the name of the set may be misspelt, which CMK110 reports
        for name, words in self.filled().items():
            if name not in named:
                linked = [each for _, each in words if not self.is_plugin(each)]
                first = (linked or [each for _, each in words])[0]
                project = self.project_around(words[0][0].path)
                shown = f"{project}::{cmake.export_names.get(first.name, first.name)}"
                otherwise = bool(cmake.named("ament_export_libraries"))
                yield UnexportedSet(words[0][0], shown, otherwise, any(each.is_built for _, each in words))

    def project_around(self, path: str) -> str:
        """Return the name of the project that a CMakeLists.txt is part of: its own, or the one around it."""
        own = [call.words[0] for call in self.package.cmake.named("project") if call.path == path and call.words]
        return own[-1].text if own and own[-1].is_known else self.package.cmake.project_name

    def filled(self) -> dict[str, list[tuple[Word, Target]]]:
        """Name of a set → the libraries in it that others may link, with where their rule names the set."""
        found: dict[str, list[tuple[Word, Target]]] = {}
        for rule in self.package.cmake.installs:
            if rule.export is not None and rule.export.is_known and not rule.call.maybe:
                for word in filter(self.is_library, rule.items):
                    if (target := self.package.cmake.target(word.text)) is not None:
                        found.setdefault(rule.export.text, []).append((rule.export, target))
        return found

    def is_library(self, word: Word) -> bool:
        target = self.package.cmake.target(word.text)
        is_own = target is not None and target.is_library and target.call.name not in PARAMETERS
        return target is not None and is_own and not self.is_only_loaded(target)

    def is_only_loaded(self, target: Target) -> bool:
        """Return whether a library is a component, or a source of it registers a class: pluginlib or a container loads
        it, and nothing links it."""
        if any(each.target.text == target.name for each in self.package.cmake.components):
            return True
        return any(any(file.calls_to(*REGISTERS)) for file in self.sources_of(target))

    def sources_of(self, target: Target) -> list[CppFile]:
        paths = {path_in_package(word.text, target.call.folder) for word in target.sources}
        return [file for file in self.sources if file.path in paths]

    def is_plugin(self, target: Target) -> bool:
        """Return whether a program may load a library by its path: a description for pluginlib names it, or a macro in
        a source of it or a definition makes it a plugin of Gazebo or a library of tree nodes."""
        cmake = self.package.cmake
        name = cmake.output_names.get(target.name, target.name)
        is_exported = any(DEFINITION in call.texts for call in cmake.named(DEFINES) if call.texts[:1] == (target.name,))
        is_made = any(LOADED.search(file.source.text) for file in self.sources_of(target))
        return name in self.described or is_exported or is_made

    @cached_property
    def described(self) -> frozenset[str]:
        """The libraries that descriptions name which CMake exports, without their folders and `lib`."""
        classes = (each for file in self.descriptions if file.is_indexed for each in file.classes)
        paths = (each.path.value.strip() for each in classes if each.path is not None)
        return frozenset(path.rpartition("/")[2].removeprefix("lib") for path in paths)

    def named(self) -> Iterator[str]:
        """Yield what commands besides `install(TARGETS)` are given; UNKNOWN where one may export any set.

        The name of a target means the target, but where sets are exported: both may be called alike.
        """
        for call in (*self.package.cmake.calls, *self.package.cmake.unreachable):
            if call.name in EXPORTS:
                yield from (UNKNOWN if UNKNOWN in text else text for text in call.texts)
            elif not fills(call):
                known = (text for text in call.texts if UNKNOWN not in text)
                yield from (text for text in known if self.package.cmake.target(text) is None)


def fills(call: EvaluatedCommand) -> bool:
    return call.name == "install" and call.texts[:1] == ("TARGETS",)

"""Sets of targets that `install(TARGETS … EXPORT set)` fills and that nothing hands on to other packages."""

from __future__ import annotations

from collections.abc import Iterator

from ...languages.cmake.evaluated_command import EvaluatedCommand, path_in_package
from ...languages.cmake.targets import Target
from ...languages.cmake.values import UNKNOWN, Word
from ...languages.cpp.file import CppFile
from ...light_dataclasses import dataclass
from ...package.cmake.cmake_package import CMakePackage
from ...package.cmake.foreign_commands import foreign_commands
from ...package.cmake.needed_files import PARAMETERS
from .missing_export_dependencies import REGISTERS
from .target_references import EXPORTS, TargetReferences


@dataclass(frozen=True)
class UnexportedSet:
    word: Word
    """The name of the set, where it is first filled."""
    library: str
    """The first library in it, as others would link it."""
    is_handed_on: bool
    """Whether libraries are handed on without targets, by `ament_export_libraries`."""


@dataclass(frozen=True)
class UnexportedTargets:
    package: CMakePackage
    sources: tuple[CppFile, ...]

    def all(self) -> Iterator[UnexportedSet]:
        """Yield each set with a library that others may link, once; nothing where any command may hand it on."""
        cmake = self.package.cmake
        is_clear = cmake.is_complete and not cmake.reads_unknown_files and cmake.ends_a_package
        if not self.package.is_ament or not is_clear or next(foreign_commands(cmake), None) is not None:
            return
        seen = set(self.named())
        if UNKNOWN in seen or any(each.kind == "export" for each in TargetReferences(cmake).broken()):
            return  # the name of the set may be misspelt, which CMK110 tells
        for rule in cmake.installs:
            word, library = rule.export, next(filter(self.is_library, rule.items), None)
            if word is None or library is None or not word.is_known or word.text in seen or rule.call.maybe:
                continue
            seen.add(word.text)
            target = cmake.export_names.get(library.text, library.text)
            handed_on = bool(cmake.named("ament_export_libraries"))
            yield UnexportedSet(word, f"{cmake.project_name}::{target}", handed_on)

    def is_library(self, word: Word) -> bool:
        target = self.package.cmake.target(word.text)
        is_own = target is not None and target.is_library and target.call.name not in PARAMETERS
        return target is not None and is_own and not self.is_only_loaded(target)

    def is_only_loaded(self, target: Target) -> bool:
        """Return whether a library is a component, or a source of it registers a class: pluginlib or a container loads
        it, and nobody links it."""
        if any(each.target.text == target.name for each in self.package.cmake.components):
            return True
        paths = {path_in_package(word.text, target.call.folder) for word in target.sources}
        return any(file.path in paths and any(file.calls_to(*REGISTERS)) for file in self.sources)

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

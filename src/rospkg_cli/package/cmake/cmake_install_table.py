"""The install table of a package that CMake builds."""

from __future__ import annotations

import posixpath
from collections.abc import Iterator

from ...languages.cmake.evaluated_command import EvaluatedCommand
from ...languages.cmake.values import UNKNOWN, Word
from ...light_dataclasses import replace
from ..install_table import InstalledFile, InstallTable, UnknownPart
from .ament_python_install import python_scripts
from .artifacts import Artifacts
from .cmake_project import CMake
from .copied_files import copied_files
from .install_kinds import InstallKinds
from .install_rule import InstallRule
from .macro_installs import PACKAGE, installed_by_macros
from .unknown_installs import UnknownInstalls, lies_outside


def cmake_table(cmake: CMake, name: str) -> InstallTable:
    """Return what the package called `name` installs; what ament writes itself (hooks, configs) is left out."""
    rows = tuple(dict.fromkeys(CMakeTableBuilder(cmake, name).rows()))
    return InstallTable(rows, tuple(UnknownInstalls(cmake, name, rows).all()))


class CMakeTableBuilder:
    def __init__(self, cmake: CMake, name: str) -> None:
        self.cmake = cmake
        self.name = name
        self.artifacts = Artifacts(cmake)
        self.kinds = InstallKinds(name, cmake.project_name)

    def rows(self) -> Iterator[InstalledFile]:
        if ends := self.cmake.named(*PACKAGE):
            manifest = InstalledFile("share", f"share/{self.name}/package.xml", "package.xml", "", "package.xml")
            yield replace(manifest, maybe=all(call.maybe for call in ends))
        for rule in self.cmake.installs:
            if rule.kind == "TARGETS":
                yield from self.targets(rule)
            else:
                yield from self.files(rule)
        yield from self.automatic()
        yield from (self.row(*made) for made in installed_by_macros(self.cmake, self.name))
        yield from (each for each in self.python_scripts() if isinstance(each, InstalledFile))

    def row(self, destination: str, source: str, word: Word, *calls: EvaluatedCommand) -> InstalledFile:
        """Return the row of an argument; `calls` must all be run for it to be installed."""
        maybe, testing = word.maybe or any(call.maybe for call in calls), any(call.testing for call in calls)
        return InstalledFile(self.kinds.of(destination), destination, source, "", word.path, word.span, maybe, testing)

    def files(self, rule: InstallRule) -> Iterator[InstalledFile]:
        for copy in copied_files(rule, self.cmake.package_files):
            yield self.row(copy.destination, copy.source, copy.item, rule.call)
        if rule.kind in ("FILES", "PROGRAMS") and rule.destination is not None:
            for word in (each for each in rule.items if lies_outside(each, rule.call.folder)):
                name = rule.rename.text if rule.rename else posixpath.basename(word.text)
                yield self.row(posixpath.normpath(posixpath.join(rule.destination, name)), "", word, rule.call)

    def targets(self, rule: InstallRule) -> Iterator[InstalledFile]:
        for word in rule.items:
            target = self.cmake.target(word.text)
            if target is None and word.is_known and (missing := self.missing_executable(rule, word)):
                yield missing
            place = self.artifacts.destination(rule, target) if target is not None and target.is_built else None
            if target is not None and place is not None:
                path = posixpath.join(place, self.artifacts.file_name(target))
                row = self.row(path, "", word, rule.call, target.call)
                yield replace(row, what="executable") if target.is_executable and place == "lib" else row

    def missing_executable(self, rule: InstallRule, word: Word) -> InstalledFile | None:
        """Return the row of a target that nothing makes: that is one fault, and what starts it is no other one."""
        destinations = rule.destinations or {}
        place = destinations.get("RUNTIME", destinations.get(""))
        return self.row(f"{place}/{word.text}", "", word, rule.call) if place == f"lib/{self.name}" else None

    def automatic(self) -> Iterator[InstalledFile]:
        """Yield what ament_auto_package installs without a rule: the targets of ament_auto_add_*, and include/."""
        for call in self.cmake.named("ament_auto_package", "autoware_ament_auto_package")[:1]:
            place = "bin" if "INSTALL_TO_PATH" in call.texts else f"lib/{self.name}"
            for target in self.cmake.targets:
                if target.call.name == "ament_auto_add_executable" and UNKNOWN not in target.name:
                    yield self.row(f"{place}/{self.artifacts.file_name(target)}", "", target.word, target.call)
                elif target.call.name == "ament_auto_add_library" and target.is_built and UNKNOWN not in target.name:
                    yield self.row(f"lib/{self.artifacts.file_name(target)}", "", target.word, target.call)
            scope = f"include/{self.name}" if "USE_SCOPED_HEADER_INSTALL_DIR" in call.texts else "include"
            for path in self.cmake.package_files.below("include"):
                place = posixpath.join(scope, path.removeprefix("include/"))
                yield InstalledFile("header", place, path, "", call.path, call.command.name_span)

    def python_scripts(self) -> Iterator[InstalledFile | UnknownPart]:
        for call in self.cmake.named("ament_python_install_package"):
            yield from python_scripts(call, self.cmake.package_files)

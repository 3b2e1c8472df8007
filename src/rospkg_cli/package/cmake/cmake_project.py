"""CMakeLists.txt and the files it includes, evaluated: the input of rules and PackageFacts."""

from __future__ import annotations

from functools import cached_property

from ...files import PackageFiles
from ...languages.cmake.evaluated_command import EvaluatedCommand
from ...languages.cmake.file import ROOT, CMakeFile
from ...languages.cmake.syntax import CommandInvocation
from ...languages.cmake.targets import Target, targets_by_name, targets_of
from ...languages.cmake.values import Word
from ...light_dataclasses import dataclass, field
from .ament_installs import install_rules
from .components import Component, components_of
from .find_package import FoundPackage, found_packages
from .install_rule import InstallRule
from .interface_targets import InterfaceTarget, generated_files, interface_targets_of
from .project_name import are_only_tests, ends_a_package, last_project
from .target_properties import SETTERS, output_names, properties


@dataclass(frozen=True)
class CMake:
    """The commands of a package as CMake would run them, in order."""

    package_files: PackageFiles = field(repr=False)
    files: tuple[CMakeFile, ...]
    calls: tuple[EvaluatedCommand, ...]
    unreachable: tuple[EvaluatedCommand, ...] = ()
    """Commands in branches that are never taken and loops over nothing."""
    stopped: str = ""
    """Why the evaluation stopped early: then nothing may be concluded from what is missing."""
    reads_unknown_files: bool = False
    """Whether it includes files that can't be read: they may add any target."""
    includes_unknown_files: bool = False
    """Whether not all of these are folders that are not there, as of submodules."""
    own_name: str = ""
    """The package's name, which a macro may read out of package.xml for project()."""

    @property
    def is_complete(self) -> bool:
        return not self.stopped

    @property
    def root(self) -> CMakeFile:
        return self.files[0]

    def file(self, path: str) -> CMakeFile:
        """Return the file with a path; raises KeyError."""
        return self._files[path]

    @cached_property
    def _files(self) -> dict[str, CMakeFile]:
        return {file.path: file for file in self.files}

    def last_index(self, command: CommandInvocation) -> int:
        """Return the index of the last call of a command, -1 where it is never run."""
        return self._places.get(id(command), -1)

    @cached_property
    def _places(self) -> dict[int, int]:
        return {id(call.command): place for place, call in enumerate(self.calls)}

    @cached_property
    def functions(self) -> frozenset[str]:
        """The names of the package's own functions and macros."""
        commands = (command for file in self.files for command in file.syntax.commands)
        defined = [command for command in commands if command.name in ("function", "macro") and command.arguments]
        return frozenset(command.arguments[0].text.lower() for command in defined)

    def source_text(self, word: Word) -> str:
        """Return the source text of a word: `${LIBRARY}`, `"a b"`."""
        return self.file(word.path).source.slice(word.span)

    def quoted(self, word: Word) -> str:
        """Return a word for a message, with its source text where that differs."""
        raw = self.source_text(word).strip('"')
        return f"`{word.text}`" if raw == word.text or not raw else f"`{word.text}` (`{raw}`)"

    @cached_property
    def _by_name(self) -> dict[str, list[EvaluatedCommand]]:
        found: dict[str, list[EvaluatedCommand]] = {}
        for call in self.calls:
            found.setdefault(call.name, []).append(call)
        return found

    def named(self, *names: str) -> list[EvaluatedCommand]:
        """Return the calls of the commands with these names, in order."""
        there = [name for name in names if name in self._by_name]
        if len(there) <= 1:
            return self._by_name[there[0]] if there else []
        return [call for call in self.calls if call.name in there]

    @cached_property
    def projects(self) -> tuple[EvaluatedCommand, ...]:
        """The calls of project() in CMakeLists.txt itself."""
        return tuple(call for call in self.named("project") if call.path == ROOT and call.words)

    @cached_property
    def project(self) -> Word | None:
        """The name that ament_package() uses."""
        return last_project(self.calls)

    @property
    def project_name(self) -> str:
        if self.project is None:
            return ""
        return self.project.text if self.project.is_known else self.own_name

    @property
    def ends_a_package(self) -> bool:
        return ends_a_package(self.calls)

    @cached_property
    def exports(self) -> tuple[EvaluatedCommand, ...]:
        """The calls of ament_export_targets that count: those in a sub-folder set a variable that is lost there."""
        calls = self.named("ament_export_targets", "ament_export_interfaces")
        return tuple(call for call in calls if not call.folder)

    @cached_property
    def only_tests(self) -> bool:
        """Whether all that is built, installed or exported is for tests."""
        return are_only_tests(self.calls)

    @cached_property
    def targets(self) -> tuple[Target, ...]:
        return tuple(targets_of(self.calls))

    @cached_property
    def _targets_by_name(self) -> dict[str, Target]:
        return targets_by_name(self.targets)

    def target(self, name: str) -> Target | None:
        return self._targets_by_name.get(name)

    @cached_property
    def installs(self) -> tuple[InstallRule, ...]:
        return tuple(install_rules(self.calls, self.project_name))

    @cached_property
    def components(self) -> tuple[Component, ...]:
        return tuple(components_of(self.calls))

    @cached_property
    def interface_targets(self) -> tuple[InterfaceTarget, ...]:
        return tuple(interface_targets_of(self.calls))

    @cached_property
    def generated_interfaces(self) -> dict[str, bool]:
        """The interface files of the package that are generated, by path: whether that is certain."""
        return generated_files(self.interface_targets)

    @cached_property
    def knows_interfaces(self) -> bool:
        """Whether no other interface file of the package is generated."""
        unclear = not self.is_complete or self.reads_unknown_files
        return not unclear and all(word.is_known for target in self.interface_targets for word in target.files)

    @cached_property
    def packages(self) -> tuple[FoundPackage, ...]:
        """The calls of find_package."""
        return tuple(found_packages(self.calls))

    @cached_property
    def output_names(self) -> dict[str, str]:
        """Targets whose file has another name: target to name."""
        return output_names(self.named(*SETTERS), self._targets_by_name)

    @cached_property
    def export_names(self) -> dict[str, str]:
        """Targets that are exported under another name: target to name."""
        return dict(properties(self.named(*SETTERS), "EXPORT_NAME"))

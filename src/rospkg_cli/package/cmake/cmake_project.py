"""CMakeLists.txt and the files it includes, evaluated: the input of rules and PackageFacts."""

from __future__ import annotations

from collections.abc import Iterator
from fnmatch import fnmatchcase
from functools import cached_property

from ...files import PackageFiles
from ...languages.cmake.evaluated_command import EvaluatedCommand
from ...languages.cmake.file import ROOT, CMakeFile
from ...languages.cmake.syntax import CommandInvocation
from ...languages.cmake.targets import MAKERS, Target, targets_by_name, targets_of
from ...languages.cmake.values import UNKNOWN, Word
from ...lazy_regex import regex
from ...light_dataclasses import dataclass, field
from .ament_installs import install_rules
from .components import Component, InterfaceTarget, components_of, interface_targets_of
from .find_package import FoundPackage, found_packages
from .install_rules import InstallRule

PACKAGE_ENDS = ("ament_package", "ament_auto_package")
"""How the commands are called that end a package."""

TESTS = regex(r"(?:ament_)?add_\w*(?:test|gmock)\w*|rosidl_generate_interfaces")
"""Commands that make a test, and what tests use."""


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

    def mentions_file(self, path: str) -> bool:
        """Return whether a command names a file, with or without its suffixes, or a launch test may do so."""
        name = path.rpartition("/")[2]
        wanted = (name, name.partition(".")[0], name.rpartition(".")[0])
        for call in self.calls:
            if call.may_have_more and any(each in call.name for each in ("launch", "ros_test", "pytest")):
                return True
            for last in (text.rpartition("/")[2] for text in call.texts):
                if last in wanted or (
                    UNKNOWN in last and last.strip(UNKNOWN) and fnmatchcase(name, last.replace(UNKNOWN, "*"))
                ):
                    return True
        return False

    @cached_property
    def projects(self) -> tuple[EvaluatedCommand, ...]:
        """The calls of project() in CMakeLists.txt itself."""
        return tuple(call for call in self.named("project") if call.path == ROOT and call.words)

    @cached_property
    def project(self) -> Word | None:
        """The name that ament_package() goes by: that of the last project() before it."""
        ends = [at for at, call in enumerate(self.calls) if call.name.endswith(PACKAGE_ENDS)]
        before = self.calls[: ends[-1]] if ends else ()
        last = next((c for c in reversed(before) if c.name == "project" and c.path == ROOT and c.words), None)
        call = last or next(iter(self.projects), None)
        return call.words[0] if call is not None else None

    @property
    def project_name(self) -> str:
        if self.project is None:
            return ""
        return self.project.text if self.project.is_known else self.own_name

    @property
    def ends_a_package(self) -> bool:
        """Whether `ament_package` is called, by whatever name."""
        return any(call.name.endswith(PACKAGE_ENDS) for call in self.calls)

    @cached_property
    def exports(self) -> tuple[EvaluatedCommand, ...]:
        """The calls of ament_export_targets that count: those in a sub-folder set a variable that is lost there."""
        calls = self.named("ament_export_targets", "ament_export_interfaces")
        return tuple(call for call in calls if not call.folder)

    @cached_property
    def only_tests(self) -> bool:
        """Whether all that is built, installed or exported is for tests, of which linters alone are none."""
        done = [call for call in self.calls if call.name == "install" or call.name in MAKERS or "export" in call.name]
        made = [call for call in self.calls if call.testing and (call.name in MAKERS or TESTS.fullmatch(call.name))]
        return bool(made) and all(call.testing for call in done)

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
        found: dict[str, bool] = {}
        for target in self.interface_targets:
            for word in target.files:
                if (path := target.path_of(word)) is not None:
                    found[path] = found.get(path, False) or not (word.maybe or target.call.maybe)
        return found

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
        """Targets whose file has another name: target to name; that of its kind of artifact goes before."""
        found = dict(self.properties("OUTPUT_NAME"))
        for kind in ("RUNTIME", "ARCHIVE", "LIBRARY"):
            for target, new in self.properties(f"{kind}_OUTPUT_NAME"):
                if (known := self.target(target)) is not None and known.artifact == kind:
                    found[target] = new
        return found

    @cached_property
    def export_names(self) -> dict[str, str]:
        """Targets that are exported under another name: target to name."""
        return dict(self.properties("EXPORT_NAME"))

    def properties(self, name: str) -> Iterator[tuple[str, str]]:
        """Yield target and value for each place where a property of that name is set; the last one counts."""
        for call in self.named("set_target_properties", "set_property"):
            texts = call.texts
            start = "PROPERTIES" if call.name == "set_target_properties" else "PROPERTY"
            at = texts.index(start) if start in texts else len(texts)
            pairs = texts[at + 1 :] if start == "PROPERTIES" else texts[at + 1 : at + 3]
            targets = [text for text in texts[:at] if text not in ("TARGET", "APPEND", "APPEND_STRING")]
            for key, value in zip(pairs[::2], pairs[1::2], strict=False):
                yield from ((target, value) for target in targets if key == name)

"""Headers of packages that CMake finds and that the target which includes them is not linked with (CMK121)."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from functools import cached_property

from ...languages.cmake.evaluated_command import EvaluatedCommand, path_in_package
from ...languages.cmake.targets import Target
from ...languages.cmake.values import UNKNOWN, Word
from ...languages.cpp.file import CppFile
from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...package.cmake.set_variables import SetVariables
from ...package.cmake.target_links import TargetLink, TargetLinks
from ...package.workspace import Workspace
from ...ros.aliases import keys_for_cmake
from ...ros.manifest import EXPORTED
from ...ros.names import NameKind
from ...ros.read_table import rows
from ...source import Span
from ..cmake.missing_export_dependencies import BY_MACRO, TABLES
from .compiled_sources import Inclusions
from .linked_at_run_time import VARIABLE
from .undeclared_includes import IncludeDependencies

PLAIN = frozenset({"add_executable", "add_library"})
"""Commands that make targets which are linked with nothing but what other commands name."""
FOLDERS = regex(r"\$\{([\w.+-]+?)_INCLUDE_DIRS?\}")
WORDS = frozenset({"AFTER", "BEFORE", "SYSTEM"})
PASSED_ON = EXPORTED | {"build_depend"}


@dataclass(frozen=True, slots=True)
class UnlinkedInclude:
    target: Target
    package: str
    header: str
    path: str
    span: Span
    is_own_folder: bool
    """Whether the package certainly installs its headers into a folder that nobody else looks into."""
    bringer: str = ""
    """The package that may bring it, of which nobody knows what it brings."""


@dataclass(frozen=True)
class UnlinkedIncludes:
    includes: IncludeDependencies

    def all(self) -> Iterator[UnlinkedInclude]:
        """Yield each package once that a target includes, also by its own headers, and certainly does not get."""
        cmake = self.includes.cmake
        if not self.includes.declared.is_checked or not cmake.is_complete or cmake.reads_unknown_files:
            return
        links = cmake.named("target_link_libraries", "ament_target_dependencies")
        if any(map(self.serves_all, cmake.calls)) or any(
            cmake.target(call.texts[0]) is None for call in links if call.texts
        ):
            return  # a link of a target that is not there is one that another lacks
        seen: set[str] = set()
        for target in cmake.targets:
            if target.call.name in PLAIN and target.is_built and not target.call.maybe and not target.call.testing:
                for each in self.of(target):
                    if each.package not in seen:
                        seen.add(each.package)
                        yield each

    def serves_all(self, call: EvaluatedCommand) -> bool:
        """Return whether a command may bring the headers of a package of ROS to all targets."""
        if call.name != "include_directories":
            return call.name == "link_libraries"
        return not all(word.text in WORDS or self.is_no_package(word, call) for word in call.words)

    def is_no_package(self, word: Word, call: EvaluatedCommand) -> bool:
        """Return whether a folder is one of the package itself, or of what is no package of ROS: `${Boost_…}`."""
        if word.is_known:
            return path_in_package(word.text, call.folder) is not None
        named = FOLDERS.fullmatch(self.includes.cmake.source_text(word).strip('"'))
        kind_of = self.includes.declared.workspace.kind_of
        return named is not None and kind_of(named[1]) is not NameKind.PACKAGE and bool(keys_for_cmake(named[1]))

    def of(self, target: Target) -> Iterator[UnlinkedInclude]:
        included = {name: use for name, use in self.included(target) if name in self.found}
        names = self.linked(target.name) if included else None
        if names is None:
            return
        there, is_whole = self.closure(names)
        bringer = "" if is_whole else next(name for name in sorted(names) if not self.closure([name])[1])
        for name, (file, header, span) in included.items():
            if name not in there and not self.has_folder_of(target.name, name):
                yield UnlinkedInclude(target, name, header, file, span, self.has_own_folder(name), bringer)

    def included(self, target: Target) -> Iterator[tuple[str, tuple[str, str, Span]]]:
        """Yield the packages whose headers a target's sources include in any case, each with the places."""
        words = (word for word in target.sources if word.is_known and not word.maybe)
        paths = {path_in_package(word.text, target.call.folder) for word in words}
        for path in sorted(self.inclusions.reached(path for path in paths if path in self.files)):
            for each in self.files[path].includes:
                slash = "/" in each.path
                if slash and not each.is_conditional and not self.includes.is_own(each.path):
                    names, cmake = self.includes.providers(each.path)
                    if names[:1] == (cmake,) and path not in self.includes.guarded:
                        yield cmake, (path, each.path, each.span)

    @cached_property
    def files(self) -> dict[str, CppFile]:
        return {source.path: source for source in self.includes.sources}

    @cached_property
    def inclusions(self) -> Inclusions:
        return Inclusions(self.files)

    @cached_property
    def links(self) -> TargetLinks:
        return TargetLinks(self.includes.cmake)

    @cached_property
    def variables(self) -> SetVariables:
        return SetVariables(self.includes.cmake)

    @cached_property
    def found(self) -> frozenset[str]:
        """The packages that CMake certainly finds, and of which ROS knows that they are packages."""
        kind_of = self.includes.declared.workspace.kind_of
        packages = (each for each in self.includes.cmake.packages if not each.call.maybe)
        return frozenset(each.name for each in packages if kind_of(each.name) is NameKind.PACKAGE)

    def linked(self, name: str) -> set[str] | None:
        """Return the packages that a target is linked with, by way of own ones too; None where they are not known."""
        found: set[str] = set()
        waiting, seen = [(name, True)], set[str]()
        while waiting:
            target, is_first = waiting.pop()
            if target in seen:
                continue
            seen.add(target)
            made = self.includes.cmake.target(target)
            found |= BY_MACRO.get(made.call.name, frozenset()) if made else frozenset()
            for link in self.links.of(target):
                if is_first or link.is_public:
                    own = self.links.own(link.word.text) if not link.package else None
                    packages = self.packages_of(link) if own is None else []
                    if packages is None:
                        return None
                    found.update(packages)
                    waiting += [(own.name, False)] if own is not None else []
        return found

    def packages_of(self, link: TargetLink) -> list[str] | None:
        """Return the ROS packages that an argument of a link stands for; None where that is not known."""
        text, cmake = link.word.text, self.includes.cmake
        if named := VARIABLE.fullmatch(cmake.source_text(link.word).strip('"')):
            return [] if keys_for_cmake(named[1]) else [named[1]]
        if self.variables.empty_variable(link.word):
            return []
        if UNKNOWN in text or "$<" in text or not link.word.is_known:
            return None
        name = text.partition("::")[0]
        if self.includes.declared.workspace.kind_of(name) is NameKind.PACKAGE:
            return [name]
        is_known = not link.package and "::" not in text
        return [] if is_known or keys_for_cmake(name) else None

    def closure(self, names: Iterable[str]) -> tuple[frozenset[str], bool]:
        """Return some packages with all that is known to come with them, and whether that is known of each."""
        found, is_whole = set[str](), True
        waiting, workspace = [*names], self.includes.declared.workspace
        known = workspace.index_of(NeedsOfPackages)
        while waiting:
            name = waiting.pop()
            if name in found:
                continue
            found.add(name)
            needs = known.of(name, workspace)
            is_whole &= needs is not None
            waiting += needs or ()
        return frozenset(found), is_whole

    def has_folder_of(self, target: str, package: str) -> bool:
        """Return whether a command names the include folder of a package for a target, or anything unknown."""
        for call in self.includes.cmake.named("target_include_directories", "target_sources", "set_target_properties"):
            if call.texts[:1] == (target,):
                written = " ".join(argument.text for argument in call.command.arguments)
                if package in written or any(UNKNOWN in word.text for word in call.words):
                    return True
        return False

    def has_own_folder(self, package: str) -> bool:
        """Return whether a package has interfaces, whose headers lie in a folder of their own from Humble on."""
        facts = self.includes.declared.workspace.named(package)
        is_named_so = package.endswith(("_msgs", "_srvs", "_interfaces")) and not package.startswith("tf2_")
        return bool(facts.interfaces) if facts is not None else is_named_so


class NeedsOfPackages(dict[str, "tuple[str, ...] | None"]):
    """By name, what may come with a package, None where that is not known: the same are asked for by many targets."""

    def of(self, name: str, workspace: Workspace) -> tuple[str, ...] | None:
        if name not in self:
            self[name] = needs_of(name, workspace)
        return self[name]


def needs_of(name: str, workspace: Workspace) -> tuple[str, ...] | None:
    if (facts := workspace.named(name)) is not None:
        return tuple(need.name for need in facts.dependencies if need.tag in PASSED_ON)
    tables = [*(rows(f"{table}.txt") for table in TABLES), rows("cmake_exports.txt")]
    if any(name in table for table in tables):
        return tuple(need.lstrip("?") for table in tables for need in table.get(name, ()))
    return () if workspace.kind_of(name) is NameKind.KEY or keys_for_cmake(name) else None

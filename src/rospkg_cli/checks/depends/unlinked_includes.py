"""Headers of packages that CMake finds and that the target which includes them is not linked with (CMK121)."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cached_property

from ...languages.cmake.evaluated_command import path_in_package
from ...languages.cmake.targets import Target
from ...languages.cmake.values import UNKNOWN, Word
from ...languages.cpp.file import CppFile
from ...light_dataclasses import dataclass
from ...package.cmake.cmake_project import CMake
from ...package.cmake.set_variables import WHOLE_REFERENCE, SetVariables
from ...package.cmake.target_links import TargetLink, TargetLinks
from ...ros.aliases import keys_for_cmake
from ...ros.libraries import keys_of_linked
from ...ros.names import NameKind
from ...ros.private_links import KEPT_FROM_JAZZY
from ...source import Span
from ...suggest import near_names
from ..cmake.exported_names import BY_MACRO
from ..cmake.name_slips import LEAST
from ..cmake.unknown_commands import UnknownCommands
from ..repository.older_distribution import OlderDistribution
from .brought_by_links import BEFORE_JAZZY, SOMEWHERE, BroughtByLinks, is_of_interfaces
from .header_folders import HeaderFolders
from .header_inclusions import Inclusions
from .linked_at_run_time import VARIABLE
from .own_typesupport import with_own_interfaces
from .ros1_sources import Ros1Use
from .sources_by_use import sources_by_use
from .undeclared_includes import IncludeDependencies

PLAIN = frozenset({"add_executable", "add_library"})
"""Commands that make targets which are linked with nothing but what other commands name."""
OF_TESTS = frozenset(f"ament_add_{kind}{end}" for kind in ("gtest", "gmock") for end in ("", "_executable"))
"""Those of tests: their first argument is the target, the others are sources or options."""


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
    keeper: str = ""
    """The package that brings it up to Humble alone."""
    is_found: bool = True
    behind: Ros1Use | None = None
    """What of ROS 1 ends the build of the target."""
    is_on_demand: bool = False
    """Whether a plain build leaves the target out: EXCLUDE_FROM_ALL, and nothing else needs it."""


@dataclass(frozen=True)
class UnlinkedIncludes:
    includes: IncludeDependencies
    distribution: OlderDistribution

    def all(self) -> Iterator[UnlinkedInclude]:
        """Yield each package once that a target includes, also by its own headers, and certainly does not get."""
        cmake = self.includes.cmake
        if not self.includes.declared.is_checked or not cmake.is_complete or cmake.includes_unknown_files:
            return
        links = cmake.named("target_link_libraries", "ament_target_dependencies")
        if self.folders.for_all is None or any(cmake.target(call.texts[0]) is None for call in links if call.texts):
            return  # a link of a target that is not there is one that another lacks
        if any(UnknownCommands(cmake).all()):
            return  # CMake stops there, and a misspelt command may be the one that links
        seen: set[str] = set()
        stopping = self.includes.ros1.stopping
        for target in sorted(
            cmake.targets,
            key=lambda each: (each.call.testing, stopping(each.name) is not None or is_on_demand(cmake, each)),
        ):
            if target.call.name in PLAIN | OF_TESTS and target.is_built and not target.call.maybe:
                for each in self.of(target):
                    if each.package not in seen:
                        seen.add(each.package)
                        yield each

    def of(self, target: Target) -> Iterator[UnlinkedInclude]:
        known = self.found | self.found_for_tests if target.call.testing else self.found
        included = {name: use for name, use in self.included(target) if name in known | KEPT_FROM_JAZZY}
        names = self.linked(target.name) if included else None
        if names is None:
            return
        there = BroughtByLinks(
            frozenset(names | (self.folders.for_all or frozenset())), self.includes.declared.workspace
        )
        for name, (file, header, span) in included.items():
            if name not in there.everywhere:
                bringer, keeper = there.stranger_for(name) or self.made_elsewhere, ""
                if not bringer and name in there.within(SOMEWHERE):
                    bringer = there.bringer_of(name, SOMEWHERE)
                elif not bringer and name in there.within(BEFORE_JAZZY):
                    keeper = there.bringer_of(name, BEFORE_JAZZY)
                if name in known or keeper:
                    has_own = self.has_own_folder(name)
                    use, is_late = self.includes.ros1.stopping(target.name), is_on_demand(self.includes.cmake, target)
                    yield UnlinkedInclude(
                        target, name, header, file, span, has_own, bringer, keeper, name in known, use, is_late
                    )

    @cached_property
    def made_elsewhere(self) -> str:
        """What a target is linked with that a folder may make which is not here, as that of a submodule; else ""."""
        links = self.links.all if self.includes.cmake.reads_unknown_files else ()
        words = (link.word.text for link in links if not link.package and self.links.own(link.word.text) is None)
        return next((word for word in words if "::" not in word and not keys_of_linked(word)), "")

    def included(self, target: Target) -> Iterator[tuple[str, tuple[str, str, Span]]]:
        """Yield the packages whose headers a target's sources include in any case, each with the places."""
        sources = target.call.words[1:] if target.call.name in OF_TESTS else target.sources
        words = (word for word in sources if word.is_known and not word.maybe)
        paths = {path_in_package(word.text, target.call.folder) for word in words}
        known, _ = sources_by_use(self.includes.cmake, self.includes.sources)
        opened = paths & (known.own | known.tests)
        for path in sorted(self.inclusions.reached(path for path in opened if path in self.files)):
            for each in self.files[path].includes:
                slash = "/" in each.path
                is_certain = not each.is_conditional and not self.includes.providers.is_own(each.path)
                if slash and is_certain and self.includes.ros1.headers.may_be_in_ros2(each.path):
                    names, cmake = self.includes.providers.of(each.path)
                    if names[:1] == (cmake,) and path not in self.includes.included.guarded:
                        yield cmake, (path, each.path, each.span)

    @cached_property
    def files(self) -> dict[str, CppFile]:
        return {source.path: source for source in self.includes.sources}

    @cached_property
    def inclusions(self) -> Inclusions:
        return Inclusions(self.files, only_certain=True, unconditional=True)

    @cached_property
    def links(self) -> TargetLinks:
        return TargetLinks(self.includes.cmake)

    @cached_property
    def folders(self) -> HeaderFolders:
        return HeaderFolders(self.includes.cmake, self.includes.declared.workspace)

    @cached_property
    def variables(self) -> SetVariables:
        return SetVariables(self.includes.cmake)

    @cached_property
    def found(self) -> frozenset[str]:
        """The packages that CMake certainly finds, and of which ROS knows that they are packages."""
        return self.found_where(testing=False)

    @cached_property
    def found_for_tests(self) -> frozenset[str]:
        return self.found_where(testing=True)

    def found_where(self, *, testing: bool) -> frozenset[str]:
        kind_of = self.includes.declared.workspace.kind_of
        packages = (p for p in self.includes.cmake.packages if not p.call.maybe and p.call.testing is testing)
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
            made, folders = self.includes.cmake.target(target), self.folders.of_target(target)
            generated = with_own_interfaces(self.includes.cmake, target, self.links.of(target))
            if folders is None or generated is None:
                return None
            found.update(folders, generated)
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
            return self.folders.behind_variables(named[1])
        if self.variables.empty_variable(link.word) or self.is_library(link.word):
            return []
        if UNKNOWN in text or "$<" in text or not link.word.is_known:
            return None
        name = text.partition("::")[0]
        if self.includes.declared.workspace.kind_of(name) is NameKind.PACKAGE:
            return [name]
        if link.package and is_of_interfaces(name):
            return [name]
        if len(text) >= LEAST and near_names(text, self.made):
            return None
        is_library = not link.package and "::" not in text
        return [] if is_library or keys_for_cmake(name) else None

    @cached_property
    def made(self) -> frozenset[str]:
        """The targets that the package makes: a link that is nearly one of them is a slip (CMK110)."""
        return frozenset(each.name for each in self.includes.cmake.targets if not each.call.testing)

    def is_library(self, word: Word) -> bool:
        """Return whether a word is a variable for the path of a library that CMake looks for."""
        named = WHOLE_REFERENCE.fullmatch(self.includes.cmake.source_text(word).strip('"'))
        return named is not None and named[1] in self.searched

    @cached_property
    def searched(self) -> frozenset[str]:
        return frozenset(call.texts[0] for call in self.includes.cmake.named("find_library") if call.texts)

    def has_own_folder(self, package: str) -> bool:
        """Return whether a package has interfaces, whose headers lie in a folder of their own from Humble on."""
        facts = self.includes.declared.workspace.named(package)
        is_named_so = package.endswith(("_msgs", "_srvs", "_interfaces")) and not package.startswith("tf2_")
        return bool(facts.interfaces) if facts is not None else is_named_so


def is_on_demand(cmake: CMake, target: Target) -> bool:
    """Return whether a plain build leaves a target out, as it says so and nothing that is built needs it."""
    if "EXCLUDE_FROM_ALL" not in target.call.texts:
        return False
    users = cmake.named("target_link_libraries", "add_dependencies", "install")
    return not any(target.name in call.texts[1:] for call in users)

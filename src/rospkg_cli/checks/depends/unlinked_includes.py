"""Headers of packages that CMake finds and that the target which includes them is not linked with (CMK121)."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cached_property

from ...languages.cmake.targets import Target
from ...light_dataclasses import dataclass
from ...package.cmake.cmake_project import CMake
from ...ros.libraries import keys_of_linked
from ...ros.names import NameKind
from ...ros.private_links import KEPT_FROM_JAZZY
from ...source import Span
from ..cmake.unknown_commands import UnknownCommands
from ..repository.older_distribution import OlderDistribution
from .brought_by_links import BEFORE_JAZZY, SOMEWHERE, BroughtByLinks
from .linked_packages import LinkedPackages
from .ros1_sources import Ros1Use
from .target_includes import OF_TESTS, TargetIncludes
from .undeclared_includes import IncludeDependencies

PLAIN = frozenset({"add_executable", "add_library"})
"""Commands that make targets which are linked with nothing but what other commands name."""


@dataclass(frozen=True, slots=True)
class UnlinkedInclude:
    target: Target
    package: str
    header: str
    path: str
    span: Span
    is_own_folder: bool
    """Whether the package certainly installs its headers into a folder of its own, which no other package adds."""
    bringer: str = ""
    """A package that may bring it, as its own dependencies are unknown."""
    keeper: str = ""
    """The package that brings it up to Humble alone."""
    is_found: bool = True
    """Whether CMake looks for the package."""
    behind: Ros1Use | None = None
    """The use of ROS 1 that ends the build of the target before."""
    is_on_demand: bool = False
    """Whether a plain build leaves the target out: EXCLUDE_FROM_ALL, and nothing else needs it."""


@dataclass(frozen=True)
class UnlinkedIncludes:
    includes: IncludeDependencies
    distribution: OlderDistribution

    @cached_property
    def linked(self) -> LinkedPackages:
        return LinkedPackages(self.includes.cmake, self.includes.declared.workspace)

    @cached_property
    def opened(self) -> TargetIncludes:
        return TargetIncludes(self.includes)

    def all(self) -> Iterator[UnlinkedInclude]:
        """Yield each package once that a target includes, also by its own headers, and certainly does not get."""
        cmake = self.includes.cmake
        if not self.includes.declared.is_checked or not cmake.is_complete or cmake.includes_unknown_files:
            return
        links = cmake.named("target_link_libraries", "ament_target_dependencies")
        is_stray = any(cmake.target(call.texts[0]) is None for call in links if call.texts)
        if self.linked.folders.for_all is None or is_stray:
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
        """Yield each package that a target includes, and that its links do not bring in every distribution."""
        known = self.found | self.found_for_tests if target.call.testing else self.found
        included = {name: use for name, use in self.opened.of(target) if name in known | KEPT_FROM_JAZZY}
        names = self.linked.of(target.name) if included else None
        if names is None:
            return
        there = BroughtByLinks(
            frozenset(names | (self.linked.folders.for_all or frozenset())), self.includes.declared.workspace
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
        """A link of a target that an unread CMake file may make, as that of an empty submodule; "" for none."""
        links = self.linked.links.all if self.includes.cmake.reads_unknown_files else ()
        words = (link.word.text for link in links if not link.package and self.linked.links.own(link.word.text) is None)
        return next((word for word in words if "::" not in word and not keys_of_linked(word)), "")

    @cached_property
    def found(self) -> frozenset[str]:
        """The ROS packages that CMake certainly looks for outside of tests."""
        return self.found_where(testing=False)

    @cached_property
    def found_for_tests(self) -> frozenset[str]:
        return self.found_where(testing=True)

    def found_where(self, *, testing: bool) -> frozenset[str]:
        kind_of = self.includes.declared.workspace.kind_of
        packages = (p for p in self.includes.cmake.packages if not p.call.maybe and p.call.testing is testing)
        return frozenset(each.name for each in packages if kind_of(each.name) is NameKind.PACKAGE)

    def has_own_folder(self, package: str) -> bool:
        """Return whether a package has interfaces: from Humble on their headers are in a folder of their own."""
        facts = self.includes.declared.workspace.named(package)
        is_named_so = package.endswith(("_msgs", "_srvs", "_interfaces")) and not package.startswith("tf2_")
        return bool(facts.interfaces) if facts is not None else is_named_so


def is_on_demand(cmake: CMake, target: Target) -> bool:
    """Return whether a plain build leaves a target out: EXCLUDE_FROM_ALL, and nothing that is built needs it."""
    if "EXCLUDE_FROM_ALL" not in target.call.texts:
        return False
    users = cmake.named("target_link_libraries", "add_dependencies", "install")
    return not any(target.name in call.texts[1:] for call in users)

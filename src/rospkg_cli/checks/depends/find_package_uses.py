"""Where a build uses a package that find_package() should look for: links, interfaces and headers."""

from __future__ import annotations

from collections.abc import Iterator

from ...light_dataclasses import dataclass
from ...package.cmake.target_links import TargetLinks
from ...source import Span
from .transitive_dependencies import exported_by
from .undeclared_includes import IncludeDependencies

FOUND_WITH_GENERATORS = frozenset({"action_msgs", "builtin_interfaces", "service_msgs", "unique_identifier_msgs"})
"""Packages of interfaces that `rosidl_default_generators` finds, as all services and actions need them."""

LISTED = "`rosidl_generate_interfaces` depends on it"


@dataclass(frozen=True, slots=True)
class MissingFindPackage:
    name: str
    path: str
    span: Span
    testing: bool
    usage: str
    """What is done with the package there, as a clause: `x` is linked with it."""
    may_be_transitive: bool
    """Whether another package that is found may look for it."""
    is_declared: bool = True


@dataclass(frozen=True)
class FindPackageUses:
    includes: IncludeDependencies
    found: frozenset[str]
    """The packages that CMake looks for."""

    def linked(self, maybe: bool) -> Iterator[MissingFindPackage]:
        """Yield the packages that targets are linked with; `maybe` is their `may_be_transitive`."""
        own = {target.name for target in self.includes.cmake.targets}
        for link in TargetLinks(self.includes.cmake).all:
            name, colons, _ = link.word.text.partition("::")
            certain = not (link.call.maybe or link.word.maybe or link.word.text in own)
            if certain and (colons or link.package):
                usage = f"`{link.target}` is linked with it"
                yield MissingFindPackage(name, link.word.path, link.word.span, link.call.testing, usage, maybe)

    def listed(self) -> Iterator[MissingFindPackage]:
        """Yield the dependencies of the package's interfaces, without those that the generators find for all."""
        there, known = exported_by(
            (each for each in self.found if not each.startswith("rosidl_")), self.includes.declared.workspace
        )
        for target in self.includes.cmake.interface_targets:
            for word in target.dependencies:
                is_certain = word.is_known and not (word.maybe or target.call.maybe)
                if is_certain and word.text not in there | FOUND_WITH_GENERATORS:
                    yield MissingFindPackage(
                        word.text, word.path, word.span, target.call.testing, LISTED, may_be_transitive=not known
                    )

    def with_generators(self) -> Iterator[MissingFindPackage]:
        """Yield dependencies of the interfaces that the generators find, unless a type of them is used (DEP108)."""
        named = {each.package for interface in self.includes.interfaces for each in interface.types}
        for target in self.includes.cmake.interface_targets:
            for word in target.dependencies if not target.call.maybe else ():
                if word.text in FOUND_WITH_GENERATORS - named and not word.maybe:
                    yield MissingFindPackage(word.text, word.path, word.span, target.call.testing, LISTED, True)

    def headers(self, maybe: bool) -> Iterator[MissingFindPackage]:
        """Yield the packages whose headers the package itself compiles; `maybe` is their `may_be_transitive`."""
        for each in self.includes.packages():
            if each.cmake == each.names[0] and not self.includes.including.are_passed_on(each):
                first = each.uses[0]
                usage = f"`{first.header}` is included here"
                yield MissingFindPackage(each.cmake, first.path, first.span, each.role == "test", usage, maybe)

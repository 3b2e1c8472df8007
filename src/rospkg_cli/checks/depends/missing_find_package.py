"""Declared packages that CMake uses without a `find_package()` (DEP107)."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cached_property

from ...languages.cmake.values import UNKNOWN
from ...lazy_regex import regex
from ...light_dataclasses import dataclass, replace
from ...ros.config_files import in_other_case
from ...ros.manifest import BUILDS
from ...ros.names import NameKind
from ...suggest import near_names
from .declared_dependencies import DeclaredDependencies
from .find_package_uses import FOUND_WITH_GENERATORS, FindPackageUses, MissingFindPackage
from .transitive_dependencies import exported_by
from .types_in_sources import OF_CLIENT_LIBRARIES
from .undeclared_includes import IncludeDependencies

AUTOMATIC = regex(r"ament_auto_find_\w+|(?!find_|ament_|gz_|ign_|nav2_|moveit_)\w*_package\w*")
"""Commands that look for packages, or probably do so, such as `autoware_package`."""

WITH_KIN = frozenset({"rcutils", "rcpputils", "std_msgs", "tf2"})
"""Packages that come with all packages of their family: `tf2` with `tf2_ros`, `std_msgs` with other messages."""

MIN_LETTERS = 5


@dataclass(frozen=True)
class MissingFindPackages:
    includes: IncludeDependencies

    def packages(self) -> Iterator[MissingFindPackage]:
        """Yield each package once: where a target is linked with it, else where its headers are included.

        What a found package certainly looks for is left out, except for links with a package that is not declared.
        """
        if self.declared.is_checked and self.is_complete:
            there, known = exported_by(self.found, self.declared.workspace)
            seen = set(self.found | there)
            listed = list(self.uses.listed())
            for each in (*listed, *self.uses.linked(not known), *self.uses.headers(not known)):
                if each.name not in seen and self.is_declared(each) and not self.has_another_name(each.name):
                    seen.add(each.name)
                    yield each
            certain = [each for each in listed if not each.may_be_transitive]
            for each in (*certain, *(self.uses.linked(maybe=False) if known else ())):
                if each.name not in seen and self.is_undeclared(each.name) and not self.has_another_name(each.name):
                    seen.add(each.name)
                    yield replace(each, is_declared=False)
            for each in self.uses.with_generators():
                if each.name not in self.found and self.is_undeclared(each.name):
                    yield replace(each, is_declared=False)
            included = (*self.includes.packages(), *self.includes.undeclared())
            reported = {name for each in included for name in (each.cmake, *each.names)}
            for each in self.uses.linked(maybe=True):
                is_new = each.name in there and each.name not in self.found | reported | {self.declared.facts.name}
                if is_new and self.is_undeclared(each.name) and not self.is_everywhere(each.name):
                    reported.add(each.name)
                    yield replace(each, is_declared=False)

    def brought(self) -> Iterator[MissingFindPackage]:
        """Yield each declared package once whose headers are included, and that another found package looks for.

        What rclcpp brings to all its users is left out, and what tests include.
        """
        if self.declared.is_checked and self.is_complete:
            there, _ = exported_by(self.found, self.declared.workspace)
            for each in self.uses.headers(maybe=True):
                is_new = each.name in there - self.found - WITH_KIN and not self.is_everywhere(each.name)
                if is_new and not each.testing and self.is_declared(each):
                    yield each

    def is_everywhere(self, name: str) -> bool:
        """Return whether it is of the interfaces that rclcpp or the generators find, or of the tools of ament."""
        return name in FOUND_WITH_GENERATORS | OF_CLIENT_LIBRARIES or name.startswith(("rosidl_", "ament_"))

    @cached_property
    def uses(self) -> FindPackageUses:
        return FindPackageUses(self.includes, self.found)

    @property
    def declared(self) -> DeclaredDependencies:
        return self.includes.declared

    @cached_property
    def found(self) -> frozenset[str]:
        """The packages that CMake looks for, and declared ones that it finds under a name in another case."""
        names = frozenset(each.name for each in self.includes.cmake.packages)
        declared = (each for each in self.declared.names if not self.declared.workspace.is_cased(each))
        return names.union(each for each in declared if in_other_case(each, names))

    def has_another_name(self, name: str) -> bool:
        """Return whether something is found that may be the same by CMake's name: `realsense2` for `librealsense2`."""
        kind_of = self.declared.workspace.kind_of
        others = (each for each in self.found if len(each) >= MIN_LETTERS and kind_of(each) is not NameKind.PACKAGE)
        return any(each.lower() in name for each in others) or bool(self.misspelt and near_names(name, self.misspelt))

    @cached_property
    def misspelt(self) -> frozenset[str]:
        """The names that CMake looks for and that are unknown, which CMK117 reports."""
        known = (NameKind.PACKAGE, NameKind.KEY)
        return frozenset(each for each in self.found if self.declared.workspace.kind_of(each) not in known)

    @property
    def is_complete(self) -> bool:
        """Whether every `find_package()` is known."""
        cmake = self.includes.cmake
        automatic = any(AUTOMATIC.fullmatch(call.name) for call in cmake.calls)
        return (
            cmake.is_complete
            and not cmake.reads_unknown_files
            and not automatic
            and not any(UNKNOWN in name for name in self.found)
        )

    def is_declared(self, each: MissingFindPackage) -> bool:
        tags = BUILDS | {"test_depend"} if each.testing else BUILDS
        package = self.declared.workspace.kind_of(each.name) is NameKind.PACKAGE
        return package and any(d.name == each.name and d.tag in tags for d in self.declared.manifest.dependencies)

    def is_undeclared(self, name: str) -> bool:
        """Return whether it is a package that package.xml has under no tag."""
        return self.declared.workspace.kind_of(name) is NameKind.PACKAGE and not self.declared.has([name])

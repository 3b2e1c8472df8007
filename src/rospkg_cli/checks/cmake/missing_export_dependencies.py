"""Packages that users of a package's libraries need, and that ament_export_dependencies lacks."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import cached_property

from ...languages.cmake.evaluated_command import path_in_package
from ...languages.cmake.values import UNKNOWN, Word
from ...light_dataclasses import dataclass
from ...package.cmake.installed_headers import INCLUDES, PLUGINS, PublicHeaders
from ...package.cmake.macro_installs import handed_on
from ...package.cmake.target_links import TargetLink, TargetLinks
from ...package.workspace import Workspace
from ...ros.config_files import in_other_case
from ...ros.read_table import rows
from .consumers import Consumers
from .exported_names import ExportedNames
from .found_with import TABLES
from .passed_packages import PassedPackages

REGISTERS = ("PLUGINLIB_EXPORT_CLASS", "RCLCPP_COMPONENTS_REGISTER_NODE", "CLASS_LOADER_REGISTER_CLASS")


@dataclass(frozen=True)
class MissingExportDependency:
    package: str
    word: Word
    link: TargetLink
    is_target: bool
    """Whether the library is exported as a target: what a target is linked with must be there."""


@dataclass(frozen=True)
class ExportedDependencies:
    headers: PublicHeaders
    workspace: Workspace
    consumers: Consumers

    def missing(self) -> Iterator[MissingExportDependency]:
        """Yield each package that an exported library passes on and that users don't find, by name or with another one.

        An installed header includes it, or the library is a target that is linked with a target of it.
        """
        cmake, exports = self.headers.package.cmake, self.exports
        automatic = cmake.named("ament_auto_package", "autoware_ament_auto_package")
        unclear = not cmake.is_complete or cmake.includes_unknown_files or automatic or UNKNOWN in exports.packages
        unclear = unclear or not exports.there[1]
        plugins = bool(cmake.named(PLUGINS))
        unused = plugins and not cmake.named(*INCLUDES) and not self.is_built_against
        if unclear or not self.headers.installed or unused:
            return
        seen: set[str] = set()
        for link in TargetLinks(cmake).all:
            package = self.passed.package_of(link)
            is_passed = link.is_public and link.target in exports.libraries
            is_passed = is_passed and not (link.call.maybe or link.word.maybe)
            included = package in self.passed.needed
            is_target = self.passed.is_target(package, link) or self.passed.is_library(package, link)
            needed = included or (link.target in exports.targets and is_target)
            if is_passed and needed and package not in seen and not self.is_there(package):
                seen.add(package)
                yield MissingExportDependency(package, link.word, link, link.target in exports.targets)

    def is_there(self, package: str) -> bool:
        """Return whether a package is exported, maybe in other letters, or most likely with one of its family."""
        in_letters = in_other_case(package, self.exports.there[0]) and not self.workspace.is_cased(package)
        return package in self.exports.there[0] | self.of_families or bool(in_letters) or self.is_in_extras(package)

    def is_in_extras(self, package: str) -> bool:
        """Return whether a file of CMake that users of the package run names another package, or may do so."""
        cmake = self.headers.package.cmake
        words = [(word, call.folder) for call in cmake.calls for word in handed_on(call, cmake)]
        paths = [path_in_package(word.text, folder) if word.is_known else None for word, folder in words]
        files = cmake.package_files
        return any(path is None or package in files.readable_text(path) for path in paths)

    def is_met(self, found: Sequence[MissingExportDependency]) -> bool:
        """Return whether a package of the workspace stops: at a target all that link it, at a header those with it."""
        for each in found:
            users = tuple(self.consumers.lacking(each.package))
            headers = None if each.is_target else self.headers.leading_to(each.package)
            if any(headers is None or user.included_headers & headers for user in users):
                return True
        return False

    @property
    def is_built_against(self) -> bool:
        """Whether a package of the workspace builds against this one: plugins and components are only loaded."""
        return bool(self.consumers.builders)

    @cached_property
    def exports(self) -> ExportedNames:
        return ExportedNames(self.headers.package.cmake, self.workspace)

    @cached_property
    def passed(self) -> PassedPackages:
        return PassedPackages(self.headers, self.exports)

    @cached_property
    def of_families(self) -> frozenset[str]:
        """The needed packages that an unknown exported one likely finds: `arm_planning` finds `arm`."""
        tables = [rows(f"{name}.txt") for name in TABLES]
        unknown = [each for each in self.exports.there[0] if self.workspace.named(each) is None]
        unknown = [each for each in unknown if not any(each in table for table in tables)]
        return frozenset(name for name in self.passed.needed if any(each.startswith(f"{name}_") for each in unknown))

"""Commands of ROS that are called although no `find_package()` finds the package that defines them."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cached_property

from ...languages.cmake.evaluated_command import EvaluatedCommand
from ...light_dataclasses import dataclass
from ...package.cmake.cmake_package import CMakePackage
from ...ros.implied_dependencies import IN_CMAKE, implied_by
from ...ros.link_targets import ROS_NAME
from ...ros.names import NameKind
from ...ros.read_table import rows
from ...suggest import near_names
from .missing_find_package import MissingFindPackages
from .transitive_dependencies import exported_by
from .undeclared_test_commands import CommandsForTests

TABLE = "command_packages.txt"
FINDS_FOR_TESTS = "ament_lint_auto_find_test_dependencies"
OF_AMENT = "ament_cmake"
"""Packages such as rclcpp find it for whoever finds them, by chance: no table says which."""


@dataclass(frozen=True, slots=True)
class UnfoundCommand:
    call: EvaluatedCommand
    package: str
    """The package to look for."""
    may_be_brought: bool
    """Whether a package that is found may look for it in turn."""


@dataclass(frozen=True)
class UnfoundCommands:
    package: CMakePackage
    missing: MissingFindPackages

    def all(self) -> Iterator[UnfoundCommand]:
        """Yield the first call for each package that is never found; nothing where it is unknown what is."""
        cmake = self.package.cmake
        if not self.missing.declared.is_checked or not self.missing.is_complete:
            return
        seen: set[str] = set()
        for call in cmake.calls:
            packages = self.providers(call)
            if not packages or call.maybe or call.function or packages[0] in seen or call.name in cmake.functions:
                continue
            seen.add(packages[0])
            there = self.certain if packages[0] == OF_AMENT else self.certain | self.brought[0]
            if not there.intersection(packages) and not self.is_reported_elsewhere(call, packages[0]):
                yield UnfoundCommand(call, packages[0], self.may_bring(call, packages[0]))

    @cached_property
    def found(self) -> frozenset[str]:
        """The packages that CMake looks for, and those that ament_lint_auto does."""
        tests = [need.name for need in self.package.manifest.dependencies if need.tag == "test_depend"]
        names = [each.name for each in self.package.cmake.packages]
        return frozenset([*names, *tests] if self.package.cmake.named(FINDS_FOR_TESTS) else names)

    @cached_property
    def certain(self) -> frozenset[str]:
        """The packages that are found, and those that are there to find others."""
        return self.found | implied_by(self.found, IN_CMAKE)

    @cached_property
    def brought(self) -> tuple[frozenset[str], bool]:
        """What comes with the packages that are found, and whether that is known of all of them."""
        return exported_by(self.found, self.missing.declared.workspace)

    def providers(self, call: EvaluatedCommand) -> tuple[str, ...]:
        return rows(TABLE).get(call.name) or rows(TABLE, "tests").get(call.name, ())

    def may_bring(self, call: EvaluatedCommand, package: str) -> bool:
        """Return whether a package that is found may find another one for who finds it; tests no released one does."""
        workspace = self.missing.declared.workspace
        if call.name in rows(TABLE, "tests"):
            known = (NameKind.PACKAGE, NameKind.KEY)
            return any(ROS_NAME.fullmatch(name) and workspace.kind_of(name) not in known for name in self.found)
        if package != OF_AMENT:
            return not self.brought[1]
        return any(ROS_NAME.fullmatch(name) and not workspace.index.is_key(name) for name in self.found)

    def is_reported_elsewhere(self, call: EvaluatedCommand, package: str) -> bool:
        """Return whether DEP104 reports it (a package for tests that is not declared), DEP107 (one that is linked), or
        CMK117 (one that is looked for under a misspelt name)."""
        if near_names(package, self.found):
            return True
        if call.name in rows(TABLE, "tests"):
            return package in self.undeclared
        return package in self.missing_names

    @cached_property
    def missing_names(self) -> frozenset[str]:
        return frozenset(each.name for each in self.missing.packages())

    @cached_property
    def undeclared(self) -> frozenset[str]:
        """The packages of commands for tests that DEP104 reports."""
        commands = CommandsForTests(self.missing.declared, self.package.cmake)
        return frozenset(each.package for each in commands.undeclared())

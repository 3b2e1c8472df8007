"""Which find_package() calls the configuration of a package certainly fails without."""

from __future__ import annotations

from functools import cached_property

from ...light_dataclasses import dataclass
from ...package.cmake.cmake_project import CMake
from ...package.cmake.find_package import FoundPackage
from ...package.interfaces.interface_file import InterfaceFile

REPORTED_ELSEWHERE = frozenset({"ament_cmake"})
"""Packages whose absence from package.xml other rules report."""

OF_COMMANDS = {
    "ament_add_gtest": "ament_cmake_gtest",
    "ament_add_gtest_executable": "ament_cmake_gtest",
    "ament_add_gmock": "ament_cmake_gmock",
    "ament_add_gmock_executable": "ament_cmake_gmock",
    "ament_add_pytest_test": "ament_cmake_pytest",
    "ament_add_google_benchmark": "ament_cmake_google_benchmark",
    "add_launch_test": "launch_testing_ament_cmake",
    "add_ros_test": "ros_testing",
    "ament_lint_auto_find_test_dependencies": "ament_lint_auto",
}
"""The package that each command for tests needs: CMake stops without it."""


@dataclass(frozen=True)
class NeededFindPackages:
    cmake: CMake
    interfaces: tuple[InterfaceFile, ...]

    def has(self, found: FoundPackage) -> bool:
        """Return whether the configuration certainly fails without it."""
        certain = found.word.is_known and not found.word.maybe and not found.call.maybe
        needed = found.is_required or (found.name in self.names and not found.is_quiet)
        return certain and needed and not self.is_reported_elsewhere(found.name)

    @cached_property
    def names(self) -> frozenset[str]:
        """What a target, an export or a command requires, with or without REQUIRED in find_package."""
        calls = (call for call in self.cmake.calls if not call.maybe and call.name not in self.cmake.functions)
        found = {*self.handed_to_ament, *(OF_COMMANDS[call.name] for call in calls if call.name in OF_COMMANDS)}
        for call in self.cmake.named("target_link_libraries"):
            linked = (word.text.partition("::") for word in call.words[1:] if not word.maybe and not call.maybe)
            found |= {package for package, colons, _ in linked if colons}
        return frozenset(found)

    @cached_property
    def handed_to_ament(self) -> frozenset[str]:
        """The arguments of commands of ament, which are ROS packages."""
        calls = self.cmake.named("ament_target_dependencies", "ament_export_dependencies")
        return frozenset(word.text for call in calls for word in call.words if not word.maybe and not call.maybe)

    def is_reported_elsewhere(self, name: str) -> bool:
        """Return whether another rule reports it: the one for build tools, or those for interfaces."""
        generates = name == "rosidl_default_generators" and bool(self.cmake.interface_targets)
        typed = any(each.package == name for interface in self.interfaces for each in interface.types)
        return name in REPORTED_ELSEWHERE or generates or typed

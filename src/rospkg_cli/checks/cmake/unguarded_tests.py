"""Commands for tests alone that are not inside `if(BUILD_TESTING)`."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from ...languages.cmake.evaluated_command import EvaluatedCommand
from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...package.cmake.cmake_package import CMakePackage
from ...package.cmake.cmake_project import CMake
from ...ros.manifest import DEPENDENCY_TAGS
from ..repository.kinds_installed_apart import KindsInstalledApart
from .distro_guards import guarded_commands

TEST_PACKAGES = frozenset("""
    ament_lint_auto ament_lint_common ament_cmake_gtest ament_cmake_gmock ament_cmake_pytest ament_cmake_nose
    ament_cmake_google_benchmark launch_testing_ament_cmake launch_testing ros_testing ament_cmake_copyright
    ament_cmake_cppcheck ament_cmake_cpplint ament_cmake_flake8 ament_cmake_lint_cmake ament_cmake_pep257
    ament_cmake_uncrustify ament_cmake_xmllint ament_cmake_clang_format ament_cmake_clang_tidy
""".split())  # fmt: skip
TEST_COMMANDS = frozenset("""
    ament_lint_auto_find_test_dependencies ament_add_gtest ament_add_gmock ament_add_pytest_test add_launch_test
    add_ros_test ament_auto_add_gtest ament_add_gtest_executable ament_add_gmock_executable ament_add_google_benchmark
    ament_copyright ament_cpplint ament_cppcheck ament_uncrustify ament_lint_cmake ament_flake8 ament_pep257
    ament_xmllint ament_clang_format
""".split())  # fmt: skip
OF_ROS_CORE = frozenset("""
    ament_lint_auto ament_lint_common ament_cmake_gtest ament_cmake_gmock ament_cmake_pytest launch_testing
    launch_testing_ament_cmake
""".split())  # fmt: skip
"""Those that come with `ros_core`, so with every installation of binaries that is not made for one package."""
FOR_TESTS = ("test_depend",)
OF_TARGETS = frozenset("""
    target_link_libraries target_include_directories target_compile_definitions target_compile_options target_sources
    target_compile_features ament_target_dependencies rosidl_target_interfaces set_target_properties
""".split())  # fmt: skip
"""Commands that stop where their target was not made."""
ASKED_FOR = regex(r"TARGET|TEST|test")
"""`if(TARGET …)` and options of the package's own."""


@dataclass(frozen=True)
class UnguardedTest:
    call: EvaluatedCommand
    what: str


@dataclass(frozen=True)
class UnguardedTests:
    package: CMakePackage
    kinds: KindsInstalledApart

    def all(self) -> Iterator[UnguardedTest]:
        return unguarded(self.package)

    def are_met(self, found: Iterable[UnguardedTest]) -> bool:
        """Return whether tests are left out anywhere, or a searched package is neither declared nor part of ros_core.

        `rosdep install` installs test dependencies, too, and colcon builds tests unless an option says otherwise.
        """
        looked_for = [each.what for each in found if each.call.name == "find_package"]
        depends_on = self.package.manifest.depends_on
        is_there = all(name in OF_ROS_CORE or depends_on(name, DEPENDENCY_TAGS) for name in looked_for)
        return self.kinds.are_tests_left_out or not is_there


def unguarded(package: CMakePackage) -> Iterator[UnguardedTest]:
    """Yield what finds test packages or adds tests outside of `if(BUILD_TESTING)`."""
    cmake, manifest = package.cmake, package.manifest
    if cmake.only_tests:
        return
    needed = [tag for tag in DEPENDENCY_TAGS if tag not in FOR_TESTS]
    for found in cmake.packages:
        sure = not found.call.testing and not found.call.maybe and found.is_required
        if sure and found.name in TEST_PACKAGES and not manifest.depends_on(found.name, needed):
            yield UnguardedTest(found.call, found.name)
    for call in cmake.calls:
        if call.name in TEST_COMMANDS and not call.testing and not call.maybe and not call.function:
            yield UnguardedTest(call, call.name)
    yield from of_test_targets(cmake)


def of_test_targets(cmake: CMake) -> Iterator[UnguardedTest]:
    """Yield what is said, outside, of targets that are made inside alone."""
    made = {each.name for each in cmake.targets if not each.call.testing}
    made |= {call.texts[0] for call in cmake.unreachable if call.words}
    tests = {each.name for each in cmake.targets if each.word.is_known} - made
    if not tests or cmake.reads_unknown_files:
        return
    asked = {id(each) for file in cmake.files for each in guarded_commands(file.body, ASKED_FOR)}
    for call in cmake.calls:
        first = call.texts[0] if call.name in OF_TARGETS and call.words else ""
        if first in tests and not (call.testing or call.maybe or call.function) and id(call.command) not in asked:
            yield UnguardedTest(call, f"{call.name}({first} …)")

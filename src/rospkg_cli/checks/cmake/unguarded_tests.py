"""Commands for tests alone that are not inside `if(BUILD_TESTING)`."""

from __future__ import annotations

from collections.abc import Iterator

from ...languages.cmake.evaluated_command import EvaluatedCommand
from ...light_dataclasses import dataclass
from ...package.cmake.cmake_package import CMakePackage
from ...ros.manifest import DEPENDENCY_TAGS

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
FOR_TESTS = ("test_depend",)


@dataclass(frozen=True)
class UnguardedTest:
    call: EvaluatedCommand
    what: str


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

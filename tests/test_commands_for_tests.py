"""Commands for tests need their packages: where DEP104 tells it, and where it keeps quiet."""

from __future__ import annotations

import pytest

from rospkg_cli.checks.depends.needed_find_packages import OF_COMMANDS
from rospkg_cli.example import CMAKE, manifest
from rospkg_cli.testing import lint_files

GTEST = "ament_add_gtest(test_a test/a.cpp)"


def said(lines: str, body: str = "", build_type: str = "ament_cmake") -> list[str]:
    """Return what DEP104 says of a package whose CMakeLists.txt has some lines."""
    cmake = CMAKE.replace("ament_package()", f"{lines}\nament_package()")
    files = {"package.xml": manifest(body, build_type), "CMakeLists.txt": cmake, "test/a.cpp": ""}
    return [finding.message for finding in lint_files(files, ["DEP104"]).findings]


@pytest.mark.parametrize(("command", "package"), OF_COMMANDS.items())
def test_each_command_names_its_package(command: str, package: str) -> None:
    (message,) = said(f"{command}(test_a test/a.cpp)")
    assert message.startswith(f"`{command}` comes with `{package}`, ")


@pytest.mark.parametrize(
    ("lines", "body"),
    [
        (GTEST, "<test_depend>ament_cmake_gtest</test_depend>"),
        (GTEST, "<buildtool_depend>ament_cmake_auto</buildtool_depend>"),
        (f"find_package(ament_cmake_ros REQUIRED)\n{GTEST}", "<buildtool_depend>ament_cmake_ros</buildtool_depend>"),
        (f"find_package(ament_cmake_gmock QUIET)\n{GTEST}", ""),
        (f"if(SOMETHING_ELSE)\n  {GTEST}\nendif()", ""),
        (f"include(${{WHEREVER}})\n{GTEST}", ""),
        (f"message(FATAL_ERROR no)\n{GTEST}", ""),
        (f"function(ament_add_gtest)\nendfunction()\n{GTEST}", ""),
        (f"find_package(ament_cmake_gtest QUIET)\n{GTEST}", ""),
    ],
)
def test_a_command_whose_package_is_around(lines: str, body: str) -> None:
    assert said(lines, body) == []


def test_a_package_is_told_once() -> None:
    assert len(said(f"{GTEST}\nament_add_gtest_executable(test_b test/a.cpp)")) == 1
    assert len(said(f"{GTEST}\nament_add_gmock(test_b test/a.cpp)")) == 2
    assert said(GTEST, build_type="catkin") == []

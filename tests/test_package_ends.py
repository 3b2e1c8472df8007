"""Macros of other packages that may call `ament_package()` (CMK003)."""

from __future__ import annotations

import pytest

from rospkg_cli.example import CMAKE, manifest
from rospkg_cli.testing import lint_files

HEAD = CMAKE.replace("ament_package()", "").rstrip() + "\nfind_package(rclcpp REQUIRED)\n"
TEAM = "find_package(team_cmake REQUIRED)\n"
BUILDS = "add_executable(talker a.cpp)\ninstall(TARGETS talker DESTINATION lib/${PROJECT_NAME})\n"
TESTS = "if(BUILD_TESTING)\n  find_package(ament_cmake_gtest REQUIRED)\n  ament_add_gtest(test_a a.cpp)\nendif()\n"
MACRO = "macro(team_finish)\n  message(STATUS done)\nendmacro()\n"
TOOLS = {
    "tools/package.xml": manifest("", "ament_cmake", name="acme_tools"),
    "tools/CMakeLists.txt": CMAKE.replace("my_pkg", "acme_tools"),
}


def told(lines: str, **more: str) -> list[str]:
    files = {
        "own/package.xml": manifest("  <depend>rclcpp</depend>\n", "ament_cmake"),
        "own/CMakeLists.txt": HEAD + lines,
        "own/a.cpp": "int main() {return 0;}\n",
    }
    return [each.severity.value for each in lint_files({**files, **more}, ["CMK003"]).findings]


@pytest.mark.parametrize(
    "lines",
    [
        TEAM + BUILDS + "team_finish()\n",
        TEAM + BUILDS + "finish(${PROJECT_NAME})\n",
        TEAM + "team_start(a)\n" + BUILDS + "team_finish()\n" + TESTS,
        TEAM + "team_add_library(a)\nteam_install(FILES a.cpp)\n",
        "if(NOT COMMAND team_start)\n  " + TEAM + "endif()\n" + BUILDS + "team_finish()\n",
        "find_package(mrt_cmake_modules REQUIRED)\nmrt_add_library(a)\nmrt_install(FILES a.cpp)\n",
    ],
)
def test_a_macro_at_the_end_may_call_it(lines: str) -> None:
    assert told(lines) == []


@pytest.mark.parametrize(
    "lines",
    [
        BUILDS,
        TEAM + BUILDS,
        TEAM + "team_start(a)\n" + BUILDS,
        TEAM + BUILDS + "team_finish()\nament_export_dependencies(rclcpp)\n",
        TEAM + BUILDS + "mesage(STATUS done)\n",
        TEAM + MACRO + BUILDS + "team_finish()\n",
        TEAM + BUILDS + "set_target_properties(talker PROPERTIES A b)\n",
        BUILDS + "finish(a)\n",
    ],
)
def test_what_no_foreign_macro_ends_is_told(lines: str) -> None:
    assert told(lines) == ["error"]


def test_a_package_here_that_has_nothing_but_cmake_may_have_the_macro() -> None:
    finds = "find_package(acme_tools REQUIRED)\n" + BUILDS + "finish(a)\n"
    assert told(finds, **TOOLS) == []
    builds = {
        "tools/CMakeLists.txt": TOOLS["tools/CMakeLists.txt"].replace("ament_package()", BUILDS + "ament_package()")
    }
    assert told(finds, **{**TOOLS, **builds, "tools/a.cpp": "int main() {return 0;}\n"}) == ["error"]

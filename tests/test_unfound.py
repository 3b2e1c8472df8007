"""DEP107: what is built against, declared and never looked for."""

from __future__ import annotations

import pytest

from rospkg_cli.example import BACKDROPS, CMAKE, existing_files, manifest
from rospkg_cli.testing import lint_files

BASE = existing_files(BACKDROPS["ament_cmake"])
LINKED = ("add_executable(node src/node.cpp)", "ament_target_dependencies(node std_msgs)")


def said(*lines: str, node: str = "", declared: str = "depend") -> list[tuple[str, str]]:
    body = f"  <{declared}>std_msgs</{declared}>\n"
    files = {
        "package.xml": manifest(body, "ament_cmake"),
        "CMakeLists.txt": CMAKE.replace("ament_package()", "\n".join([*lines, "ament_package()"])),
        "src/node.cpp": node,
    }
    found = lint_files({**BASE, **files}, ["DEP107"]).findings
    return [(finding.message.split("`")[1], finding.severity.value) for finding in found]


def test_what_is_linked() -> None:
    assert said(*LINKED) == [("std_msgs", "warning")]
    assert said(LINKED[0], "target_link_libraries(node PUBLIC std_msgs::std_msgs)") == [("std_msgs", "warning")]


def test_what_is_included() -> None:
    assert said(LINKED[0], node="#include <std_msgs/msg/string.hpp>\n") == [("std_msgs", "warning")]


@pytest.mark.parametrize(
    "line",
    [
        "find_package(std_msgs REQUIRED)",
        "foreach(p std_msgs)\n  find_package(${p} REQUIRED)\nendforeach()",
        "find_package(sensor_msgs REQUIRED)",
        "find_package(ament_cmake_auto REQUIRED)\nament_auto_find_build_dependencies()",
        "autoware_package()",
        "include(${SOMEWHERE}/dependencies.cmake)",
    ],
)
def test_what_is_found_or_may_be(line: str) -> None:
    assert said(line, *LINKED) == []


def test_what_another_may_bring_is_milder() -> None:
    assert said("find_package(who_knows_what REQUIRED)", *LINKED) == [("std_msgs", "info")]


def test_a_target_of_the_packages_own_is_not_looked_for() -> None:
    alias = "add_library(core src/node.cpp)\nadd_library(std_msgs::core ALIAS core)"
    assert said(alias, LINKED[0], "target_link_libraries(node std_msgs::core)") == []


def test_what_is_not_declared_for_the_build_is_said_elsewhere() -> None:
    assert said(*LINKED, declared="exec_depend") == []


def test_tests_find_what_they_need_themselves() -> None:
    testing = ("if(BUILD_TESTING)", "find_package(ament_cmake_gtest REQUIRED)", *LINKED, "endif()")
    assert said(*testing, declared="test_depend") == [("std_msgs", "warning")]
    files = {
        **BASE,
        "package.xml": manifest("  <test_depend>std_msgs</test_depend>\n", "ament_cmake"),
        "CMakeLists.txt": CMAKE.replace("ament_package()", "\n".join([*testing, "ament_package()"])),
        "src/node.cpp": "",
    }
    (finding,) = lint_files(files, ["DEP107"]).findings
    (edit,) = finding.fix.operations
    text = files["CMakeLists.txt"]
    after = text[: edit.span.start] + edit.text + text[edit.span.end :]
    assert "find_package(ament_cmake_gtest REQUIRED)\nfind_package(std_msgs REQUIRED)\n" in after

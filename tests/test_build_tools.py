"""Tools that CMake runs and package.xml lacks (DEP114): which count, and what makes up for them."""

from __future__ import annotations

import pytest

from rospkg_cli.example import CMAKE, manifest
from rospkg_cli.testing import lint_files

FETCH = "FetchContent_Declare(parts {} https://example.com/parts)"


def told(lines: str, body: str = "") -> list[str]:
    """Return the tags that are asked for in a package whose CMakeLists.txt has some lines."""
    files = {
        "CMakeLists.txt": CMAKE.replace("ament_package()", f"{lines}\nament_package()"),
        "package.xml": manifest(body, "ament_cmake"),
    }
    return [finding.message.rpartition("; add ")[2] for finding in lint_files(files, ["DEP114"]).findings]


@pytest.mark.parametrize(
    "lines, wanted",
    [
        (FETCH.format("GIT_REPOSITORY"), "<buildtool_depend>git</buildtool_depend>"),
        (FETCH.format("HG_REPOSITORY"), "<buildtool_depend>mercurial</buildtool_depend>"),
        (FETCH.format("SVN_REPOSITORY"), "<buildtool_depend>subversion</buildtool_depend>"),
        ("pkg_check_modules(X REQUIRED x)", "<buildtool_depend>pkg-config</buildtool_depend>"),
        ("pkg_search_module(X REQUIRED x)", "<buildtool_depend>pkg-config</buildtool_depend>"),
        (
            "if(BUILD_TESTING)\n  pkg_check_modules(X REQUIRED x)\nendif()",
            "<test_depend>pkg-config</test_depend>",
        ),
        ("if($ENV{ROS_VERSION} EQUAL 1)\nendif()", "<build_depend>ros_environment</build_depend>"),
        (
            "if(DEFINED ENV{ROS_DISTRO})\n  set(NAME $ENV{ROS_DISTRO})\nelse()\n"
            '  message(FATAL_ERROR "ROS_DISTRO is not set")\nendif()',
            "<build_depend>ros_environment</build_depend>",
        ),
        ('set(NAME "x_$ENV{ROS_DISTRO}")', "<build_depend>ros_environment</build_depend>"),
    ],
)
def test_a_tool_is_asked_for_once(lines: str, wanted: str) -> None:
    assert told(f"{lines}\n{lines}") == [wanted]


@pytest.mark.parametrize(
    "lines, body",
    [
        (FETCH.format("URL"), ""),
        ("find_package(PkgConfig)\npkg_check_modules(X x)", ""),
        ("find_package(Git REQUIRED)\nfind_package(PkgConfig REQUIRED)", ""),
        ("set(NAME $ENV{HOME})", ""),
        ("if(DEFINED ENV{ROS_DISTRO})\n  set(NAME $ENV{ROS_DISTRO})\nendif()", ""),
        (
            "if(DEFINED ENV{ROS_DISTRO})\n  set(NAME $ENV{ROS_DISTRO})\n"
            '  message(SEND_ERROR "bad ROS_DISTRO: $ENV{ROS_DISTRO}")\n'
            '  message(ERROR "bad ROS_DISTRO: ${NAME}")\nendif()',
            "",
        ),
        (
            "if(DEFINED ENV{ROS_DISTRO})\n  set(NAME $ENV{ROS_DISTRO})\nelse()\n"
            '  message(STATUS "ROS_DISTRO is not set")\nendif()',
            "",
        ),
        (FETCH.format("GIT_REPOSITORY"), "  <build_depend>git</build_depend>\n"),
        (FETCH.format("GIT_REPOSITORY"), "  <buildtool_depend>ament_cmake_vendor_package</buildtool_depend>\n"),
        ("pkg_check_modules(X REQUIRED x)", "  <depend>pkg-config</depend>\n"),
        ("set(NAME $ENV{ROS_DISTRO})", "  <buildtool_depend>autoware_cmake</buildtool_depend>\n"),
    ],
)
def test_what_is_optional_or_comes_with_others_is_left_alone(lines: str, body: str) -> None:
    assert told(lines, body) == []


def test_what_comes_with_another_on_some_distributions_is_told() -> None:
    lines = "pkg_check_modules(X REQUIRED x)"
    files = {
        "CMakeLists.txt": CMAKE.replace("ament_package()", f"{lines}\nament_package()"),
        "package.xml": manifest("  <depend>rclcpp</depend>\n", "ament_cmake"),
    }
    (finding,) = lint_files(files, ["DEP114"]).findings
    assert "it comes with `rclcpp` on some distributions alone" in finding.message


def test_what_is_asked_for_is_not_unused() -> None:
    """The words that the package stands for are looked for, since nothing names the package itself."""
    asks = 'if($ENV{ROS_DISTRO} STREQUAL "humble")\nendif()\nadd_library(x x.cpp)\n'
    for lines, count in ((asks, 0), (asks.replace("ENV{ROS_DISTRO}", "ENV{HOME}"), 1)):
        files = {
            "CMakeLists.txt": CMAKE.replace("ament_package()", f"{lines}ament_package()"),
            "package.xml": manifest("  <build_depend>ros_environment</build_depend>\n", "ament_cmake"),
            "x.cpp": "",
        }
        assert len(lint_files(files, ["DEP202"]).findings) == count


@pytest.mark.parametrize(
    "body, wanted",
    [
        ("", ["<buildtool_depend>cmake</buildtool_depend>"]),
        ("  <test_depend>ament_cmake_gtest</test_depend>\n", ["<buildtool_depend>cmake</buildtool_depend>"]),
        ("  <buildtool_depend>cmake</buildtool_depend>\n", []),
        ("  <buildtool_depend>ament_cmake</buildtool_depend>\n", []),
    ],
)
def test_a_plain_cmake_package_asks_for_cmake(body: str, wanted: list[str]) -> None:
    files = {"CMakeLists.txt": "project(my_pkg)\n", "package.xml": manifest(body, "cmake")}
    if "ament_cmake</" not in body:
        files["package.xml"] = files["package.xml"].replace("  <buildtool_depend>ament_cmake</buildtool_depend>\n", "")
    found = lint_files(files, ["DEP114"]).findings
    assert [each.message.rpartition("; add ")[2] for each in found] == wanted

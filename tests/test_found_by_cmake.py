"""What CMake has to find before it is used: packages, the commands they bring, and what they export."""

from __future__ import annotations

import pytest

from rospkg_cli.example import CMAKE, manifest
from rospkg_cli.finding import Severity
from rospkg_cli.testing import lint_files

ERROR, WARNING, INFO = Severity.ERROR, Severity.WARNING, Severity.INFO
NO_AMENT = "find_package(ament_cmake REQUIRED)\n"
GTEST = "if(BUILD_TESTING)\n  {}\nendif()"
NEEDS_GTEST = "  <test_depend>ament_cmake_gtest</test_depend>\n"
LINTS = "find_package(ament_lint_auto REQUIRED)\n  ament_lint_auto_find_test_dependencies()\n  "


def package(lines: str, body: str = "", start: str = CMAKE) -> dict[str, str]:
    cmake = start.replace("ament_package()", f"{lines}\nament_package()")
    return {"package.xml": manifest(body, "ament_cmake"), "CMakeLists.txt": cmake}


def levels(files: dict[str, str], code: str) -> list[Severity]:
    return [finding.severity for finding in lint_files(files, [code]).findings]


@pytest.mark.parametrize(
    ("lines", "expected"),
    [
        ("", [ERROR]),
        ("find_package(Eigen3 REQUIRED)", [ERROR]),
        ("find_package(eigen REQUIRED)", [ERROR]),
        ("find_package(rclcpp REQUIRED)", [INFO]),
        ("find_package(ament_cmake_auto REQUIRED)", []),
        ("find_package(ament_cmake_core REQUIRED)", []),
        ("find_package(ament_cmaek REQUIRED)", []),
        ("find_package(${SOME_PACKAGE} REQUIRED)", []),
        ("include(${SOME_FILE})", []),
        ("team_package()", []),
        ("macro(ament_package)\nendmacro()", []),
        ("ament_export_dependencies(rclcpp)", [ERROR]),
    ],
)
def test_ament_package_comes_with_ament_cmake(lines: str, expected: list[Severity]) -> None:
    assert levels(package(lines, start=CMAKE.replace(NO_AMENT, "")), "CMK114") == expected


@pytest.mark.parametrize(
    ("lines", "declared", "expected"),
    [
        ("ament_add_gtest(test_a test/a.cpp)", NEEDS_GTEST, [ERROR]),
        ("ament_add_gtest(test_a test/a.cpp)", "", []),
        (f"{LINTS}ament_add_gtest(test_a test/a.cpp)", NEEDS_GTEST, []),
        (f"{LINTS}ament_add_gtest(test_a test/a.cpp)", NEEDS_GTEST.replace("test_depend", "depend"), [ERROR]),
        ("find_package(ament_cmake_ros REQUIRED)\n  ament_add_gtest(test_a test/a.cpp)", NEEDS_GTEST, []),
        ("find_package(my_own_tools REQUIRED)\n  ament_add_gtest(test_a test/a.cpp)", NEEDS_GTEST, [INFO]),
        ("find_package(std_msgs REQUIRED)\n  ament_add_gtest(test_a test/a.cpp)", NEEDS_GTEST, [ERROR]),
        ("if(SOMETHING_ELSE)\n    ament_add_gtest(test_a test/a.cpp)\n  endif()", NEEDS_GTEST, []),
    ],
)
def test_commands_for_tests_come_with_what_is_found(lines: str, declared: str, expected: list[Severity]) -> None:
    files = {**package(GTEST.format(lines), declared), "test/a.cpp": "int main() {return 0;}\n"}
    assert levels(files, "CMK114") == expected


@pytest.mark.parametrize(
    ("lines", "codes"),
    [
        ("rosidl_generate_interfaces(${PROJECT_NAME} msg/A.msg)", ["CMK114"]),
        ("rclcpp_components_register_nodes(core my_pkg::A)", ["CMK114"]),
        (
            "add_library(core SHARED a.cpp)\ntarget_link_libraries(core rclcpp_components::component)\n"
            "rclcpp_components_register_nodes(core my_pkg::A)",
            ["DEP107"],
        ),
    ],
)
def test_a_package_that_is_linked_is_told_once(lines: str, codes: list[str]) -> None:
    files = package(lines, "  <depend>rclcpp_components</depend>\n")
    assert [finding.code for finding in lint_files(files, ["CMK114", "DEP107"]).findings] == codes


@pytest.mark.parametrize(
    ("lines", "declared", "near"),
    [
        ("find_package(rclpcp REQUIRED)", "rclcpp", "rclcpp"),
        ("find_package(rclpcp)", "rclcpp", ""),
        ("find_package(rclpcp QUIET REQUIRED)", "rclcpp", ""),
        ("find_package(Rclpcp REQUIRED)", "rclcpp", ""),
        ("find_package(rclpcp REQUIRED)", "std_msgs", ""),
        ("find_package(rclpcp REQUIRED)\nfind_package(rclcpp REQUIRED)", "rclcpp", ""),
        ("if(SOMETHING_ELSE)\n  find_package(rclpcp REQUIRED)\nendif()", "rclcpp", ""),
        ("find_package(tf2_eigne REQUIRED)", "tf2_eigen", "tf2_eigen"),
        ("find_package(tinyxml REQUIRED)", "tinyxml2", ""),
        ("find_package(rclpcp REQUIRED)\nament_export_dependencies(rclpcp)", "rclcpp", "rclcpp"),
        ("ament_export_dependencies(rclpcp)", "rclcpp", "rclcpp"),
        ("ament_export_dependencies(rclcpp Eigen3)", "rclcpp", ""),
        ("ament_export_dependencies(other)", "rclcpp", ""),
    ],
)
def test_packages_that_are_nearly_declared(lines: str, declared: str, near: str) -> None:
    found = lint_files(package(lines, f"  <depend>{declared}</depend>\n"), ["CMK117"]).findings
    assert [each.message.partition("did you mean `")[2].partition("`")[0] for each in found] == ([near] if near else [])


@pytest.mark.parametrize("module", ["cmake/Findrclpcp.cmake", "cmake/rclpcpConfig.cmake", "rclpcp-config.cmake"])
def test_a_module_of_the_package_finds_under_any_name(module: str) -> None:
    files = package("find_package(rclpcp REQUIRED)", "  <depend>rclcpp</depend>\n")
    assert levels(files, "CMK117") == [ERROR]
    assert levels({**files, module: ""}, "CMK117") == []


@pytest.mark.parametrize("command", ["ament_target_dependencies(talker core)", "ament_export_dependencies(core)"])
def test_a_target_is_no_package(command: str) -> None:
    lines = f"add_library(core src/a.cpp)\nadd_library(talker src/a.cpp)\n{command}"
    (finding,) = lint_files(package(lines), ["CMK117"]).findings
    assert "is a target of this package" in finding.message
    assert finding.fix is None
    assert levels(package(f"find_package(core REQUIRED)\n{lines}"), "CMK117") == []


@pytest.mark.parametrize(
    ("lines", "expected"),
    [
        ("macro(INSTALL)\nendmacro()", [WARNING]),
        ("macro(install)\n  if(TRUE)\n    install(FILES a DESTINATION b)\n  endif()\nendmacro()", [ERROR]),
        ("macro(install)\n  if(TRUE)\n  else()\n    _install(${ARGV})\n  endif()\nendmacro()", []),
        ("function(ament_package)\nendfunction()", [WARNING]),
        ("function(tell)\nendfunction()", []),
        ("function()\nendfunction()", []),
        ("if(NOT COMMAND ament_package)\n  function(ament_package)\n  endfunction()\nendif()", []),
    ],
)
def test_functions_that_replace_a_command(lines: str, expected: list[Severity]) -> None:
    assert levels(package(lines), "CMK116") == expected

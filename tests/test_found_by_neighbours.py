"""Names that CMake finds by other letters, commands of foreign packages, and neighbours that find a package at all."""

from __future__ import annotations

import pytest

from rospkg_cli.example import CMAKE, manifest
from rospkg_cli.testing import lint_files

CODE = "int main() { return 0; }\n"
PROGRAM = "add_executable(talker src/talker.cpp)\n"


def said(lines: str, code: str) -> list[str]:
    cmake = CMAKE.replace("ament_package()", f"{lines}\nament_package()")
    files = {"package.xml": manifest("", "ament_cmake"), "CMakeLists.txt": cmake, "src/talker.cpp": CODE}
    return [each.severity.value for each in lint_files(files, [code]).findings]


@pytest.mark.parametrize(("found", "given", "expected"), [("ompl", "OMPL", []), ("rclcpp", "RCLCPP", ["error"])])
def test_a_library_sets_what_it_has_found_in_capitals_too(found: str, given: str, expected: list[str]) -> None:
    """`find_package_handle_standard_args(ompl)` sets OMPL_FOUND; ament sets rclcpp_FOUND alone."""
    lines = f"find_package({found} REQUIRED)\n{PROGRAM}ament_target_dependencies(talker {given})"
    assert said(lines, "CMK117") == expected


@pytest.mark.parametrize(("found", "expected"), [("mrt_cmake_modules", []), ("std_msgs", ["info"])])
def test_a_command_that_begins_like_a_package_is_of_it(found: str, expected: list[str]) -> None:
    assert said(f"find_package({found} REQUIRED)\nmrt_add_library(talker src/talker.cpp)", "CMK114") == expected


@pytest.mark.parametrize(
    ("lines", "expected"),
    [
        ("find_package(my_pkg REQUIRED)\n", ["error"]),
        ("find_package(ament_cmake_auto REQUIRED)\nament_auto_find_build_dependencies()\n", ["error"]),
        ("include(${SOME_FILE})\n", ["error"]),
        ("", ["info"]),
    ],
)
def test_who_declares_a_package_stops_at_it_where_its_cmake_looks_for_it(lines: str, expected: list[str]) -> None:
    own = CMAKE.replace("ament_package()", f"{PROGRAM}ament_export_libraries(talker)\nament_package()")
    other = CMAKE.replace("my_pkg", "other").replace("ament_package()", f"{lines}{PROGRAM}ament_package()")
    files = {
        "my_pkg/package.xml": manifest("", "ament_cmake"),
        "my_pkg/CMakeLists.txt": own,
        "my_pkg/src/talker.cpp": CODE,
        "other/package.xml": manifest("  <depend>THIS</depend>\n", "ament_cmake", "other").replace("THIS", "my_pkg"),
        "other/CMakeLists.txt": other,
        "other/src/talker.cpp": CODE,
    }
    assert [each.severity.value for each in lint_files(files, ["CMK118"]).findings] == expected


@pytest.mark.parametrize(
    ("call", "expected"),
    [
        ("target_link_libraires(talker PRIVATE m)", "error"),
        ("target_lnik_libraires(talker PRIVATE m)", "info"),
    ],
)
def test_a_command_one_letter_off_is_of_nobody_else(call: str, expected: str) -> None:
    lines = f"find_package(std_msgs REQUIRED)\n{PROGRAM}{call}"
    found = said(lines, "CMK114")
    assert found == [expected] * len(found)
    strange = said(f"find_package(team_tools REQUIRED)\n{lines}", "CMK114")
    assert strange == ["info"] * len(found)


@pytest.mark.parametrize(("files", "expected"), [({}, "info"), ({"a.cpp": "int main() {}\n"}, "error")])
def test_a_package_of_cmake_files_alone_may_define_a_command(files: dict[str, str], expected: str) -> None:
    makes = "add_executable(a a.cpp)\n" if files else ""
    theirs = {
        "team_tools/package.xml": manifest("", "ament_cmake", "team_tools"),
        "team_tools/CMakeLists.txt": CMAKE.replace("my_pkg", "team_tools").replace("ament_p", f"{makes}ament_p"),
        **{f"team_tools/{path}": text for path, text in files.items()},
    }
    lines = f"find_package(team_tools REQUIRED)\n{PROGRAM}target_link_libraires(talker PRIVATE m)"
    own = {
        "a/package.xml": manifest("  <depend>team_tools</depend>\n", "ament_cmake"),
        "a/CMakeLists.txt": CMAKE.replace("ament_package()", f"{lines}\nament_package()"),
        "a/src/talker.cpp": CODE,
    }
    assert [each.severity.value for each in lint_files({**own, **theirs}, ["CMK114"]).findings] == [expected]

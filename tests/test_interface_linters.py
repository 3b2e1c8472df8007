"""Linters of interfaces that package.xml does not declare (DEP122), where they are told and where not."""

from __future__ import annotations

import pytest

from rospkg_cli.example import INTERFACES_BODY, INTERFACES_CMAKE, manifest
from rospkg_cli.testing import lint_files

FILE = '  "srv/SetMode.srv"\n'
LINTED = INTERFACES_CMAKE.replace(FILE, f"{FILE}  ADD_LINTER_TESTS\n")
FOUND = LINTED.replace("rosidl_generate", "find_package(ament_cmake_cppcheck REQUIRED)\nrosidl_generate")


@pytest.mark.parametrize(
    "cmake, lines, count",
    [
        (LINTED, "", 1),
        (LINTED.replace("ADD_LINTER_TESTS", "LIBRARY_NAME my_pkg ADD_LINTER_TESTS"), "", 1),
        (INTERFACES_CMAKE, "", 0),
        (LINTED, "  <test_depend>ament_lint_common</test_depend>\n", 0),
        (LINTED, "  <build_depend>ament_cmake_cppcheck</build_depend>\n", 0),
        (LINTED, "  <depend>ros_core</depend>\n", 0),  # which brings them
        (LINTED, "  <depend>autoware_lint_common</depend>\n", 0),
        (LINTED, "  <depend>acme_tools</depend>\n", 1),  # it is not known to bring them
        (FOUND, "", 0),  # DEP104 tells of it
        (LINTED.replace("ADD_LINTER_TESTS", "${LINTED}"), "", 0),
        (
            LINTED.replace("rosidl_generate", "if(LINTED)\nrosidl_generate").replace(
                ")\nament_exp", ")\nendif()\nament_exp"
            ),
            "",
            0,
        ),
    ],
)
def test_linters_of_interfaces(cmake: str, lines: str, count: int) -> None:
    files = {
        "package.xml": manifest(lines + INTERFACES_BODY, "ament_cmake"),
        "CMakeLists.txt": cmake,
        "msg/Status.msg": "bool is_on\n",
        "srv/SetMode.srv": "bool is_on\n---\n",
    }
    found = lint_files(files, ["DEP122"]).findings
    assert [each.severity.name for each in found] == ["INFO"] * count

"""Imports that no name of today serves, and those of files that nothing installs, imports or starts (DEP101)."""

from __future__ import annotations

import pytest

from rospkg_cli.example import BACKDROPS, CMAKE, existing_files, manifest
from rospkg_cli.testing import lint_files

PYTHON = existing_files(BACKDROPS["ament_python"])


@pytest.mark.parametrize(
    ("module", "expected"),
    [
        ("RPi.GPIO", [("info", "python-rpi.gpio-pip")]),
        ("vtk", []),
        ("serial", [("warning", "python3-serial")]),
    ],
)
def test_a_key_that_no_release_of_ubuntu_has_any_more_is_not_advised(
    module: str, expected: list[tuple[str, str]]
) -> None:
    found = lint_files({**PYTHON, "my_pkg/arm.py": f"import {module}\n"}, ["DEP101"]).findings
    assert [(each.severity.value, each.message.split("`")[1]) for each in found] == expected


HIDDEN = 'find_package(ament_cmake_python REQUIRED)\n{}\ninstall(CODE "execute_process(COMMAND ${{X}})")\nament_package'


@pytest.mark.parametrize(
    ("line", "importer", "expected"),
    [
        ("ament_python_install_package(arm)", "", []),
        ("ament_python_install_package(arm PACKAGE_DIR extra/util)", "", ["warning"]),
        ("ament_python_install_package(arm PACKAGE_DIR ${CMAKE_CURRENT_SOURCE_DIR}/extra)", "", ["warning"]),
        ("ament_python_install_package(${NAME})", "", ["info"]),
        ("ament_python_install_package(arm)", "from util.ros_utils import a\n", ["info"]),
        ("ament_python_install_package(arm)", "from util import SE3\n", []),
        ("", "", []),
    ],
)
def test_a_leftover_of_ros_1_that_nothing_installs(line: str, importer: str, expected: list[str]) -> None:
    files = {
        "package.xml": manifest("  <depend>rclpy</depend>\n", "ament_cmake"),
        "CMakeLists.txt": CMAKE.replace("ament_package", HIDDEN.format(line)),
        "arm/__init__.py": "",
        "extra/util/__init__.py": "",
        "extra/util/ros_utils.py": "import rospy\n",
        "extra/start.py": importer,
    }
    assert [each.severity.value for each in lint_files(files, ["DEP101"]).findings] == expected

"""A library that CMake looks for in a folder that the package names is an info (DEP104)."""

from __future__ import annotations

import pytest

from rospkg_cli.example import CMAKE, manifest
from rospkg_cli.testing import lint_files

MODULE = "find_path(YAML yaml.h PATHS {}/third_party)\n"


@pytest.mark.parametrize(
    ("lines", "files", "level"),
    [
        ("find_package(yaml-cpp REQUIRED)\n", {}, "warning"),
        ("find_package(yaml-cpp REQUIRED HINTS ${CMAKE_CURRENT_SOURCE_DIR}/third_party)\n", {}, "info"),
        ("find_package(yaml-cpp REQUIRED PATHS /opt/yaml NO_DEFAULT_PATH)\n", {}, "info"),
        ("find_package(yaml-cpp REQUIRED PATHS /usr/lib/cmake)\n", {}, "warning"),
        ("set(yaml-cpp_DIR /usr/local/lib/cmake/yaml-cpp)\nfind_package(yaml-cpp REQUIRED)\n", {}, "info"),
        ("set(yaml-cpp_DIR /usr/share/yaml-cpp)\nfind_package(yaml-cpp REQUIRED)\n", {}, "warning"),
        ("set(OpenCV_DIR /usr/local/opencv)\nfind_package(yaml-cpp REQUIRED)\n", {}, "warning"),
        ("list(APPEND CMAKE_PREFIX_PATH $ENV{HOME}/local)\nfind_package(yaml-cpp REQUIRED)\n", {}, "info"),
        ("list(APPEND CMAKE_PREFIX_PATH /opt/ros/humble)\nfind_package(yaml-cpp REQUIRED)\n", {}, "warning"),
        (
            "find_package(yaml-cpp REQUIRED)\n",
            {"cmake/Findyaml-cpp.cmake": MODULE.format("${CMAKE_CURRENT_LIST_DIR}")},
            "info",
        ),
        ("find_package(yaml-cpp REQUIRED)\n", {"cmake/Findyaml-cpp.cmake": MODULE.format("/usr")}, "warning"),
    ],
)
def test_levels(lines: str, files: dict[str, str], level: str) -> None:
    cmake = CMAKE.replace("ament_package()", f"{lines}ament_package()")
    package = {"CMakeLists.txt": cmake, "package.xml": manifest("", "ament_cmake"), **files}
    (only,) = lint_files(package, ["DEP104"]).findings
    assert (only.severity.value, "in a folder that is named here" in only.message) == (level, level == "info")


def test_packages_of_ros_lie_in_their_workspaces() -> None:
    lines = "set(rclcpp_DIR /somewhere)\nfind_package(rclcpp REQUIRED)\n"
    cmake = CMAKE.replace("ament_package()", f"{lines}ament_package()")
    (only,) = lint_files({"CMakeLists.txt": cmake, "package.xml": manifest("", "ament_cmake")}, ["DEP104"]).findings
    assert only.severity.value == "warning"

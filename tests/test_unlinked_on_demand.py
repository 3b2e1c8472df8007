"""Targets that include headers of what they are not linked with, and that a plain build leaves out."""

from __future__ import annotations

import pytest

from rospkg_cli.example import BACKDROPS, CMAKE, existing_files, manifest
from rospkg_cli.testing import lint_files

NEEDS = "  <depend>rclcpp</depend>\n  <depend>sensor_msgs</depend>\n"
FINDS = "find_package(rclcpp REQUIRED)\nfind_package(sensor_msgs REQUIRED)\n"
NODE = "#include <rclcpp/rclcpp.hpp>\n#include <sensor_msgs/msg/image.hpp>\nint main() {return 0;}\n"
LATE = "add_executable(node EXCLUDE_FROM_ALL src/node.cpp)\n"
LINKS = "target_link_libraries({} rclcpp::rclcpp)\n"


@pytest.mark.parametrize(
    ("lines", "expected"),
    [
        (LATE, "info"),
        ("add_executable(node src/node.cpp)\n", "warning"),
        (LATE + "add_custom_target(a ALL)\nadd_dependencies(a node)\n", "warning"),
        (LATE + "install(TARGETS node DESTINATION lib/my_pkg)\n", "warning"),
        (LATE + "add_executable(other src/node.cpp)\n", "warning"),
    ],
)
def test_who_builds_it(lines: str, expected: str) -> None:
    links = LINKS.format("node") + (LINKS.format("other") if "(other" in lines else "")
    files = {
        **existing_files(BACKDROPS["ament_cmake"]),
        "package.xml": manifest(NEEDS, "ament_cmake"),
        "CMakeLists.txt": CMAKE.replace("ament_package", f"{FINDS}{lines}{links}ament_package"),
        "src/node.cpp": NODE,
    }
    (found,) = lint_files(files, ["CMK121"]).findings
    assert found.severity.value == expected

"""A package with conditions for both versions of ROS, among packages that catkin alone builds (CMK201, DEP203)."""

from __future__ import annotations

import pytest

from rospkg_cli.example import CMAKE, manifest
from rospkg_cli.testing import lint_files

BOTH = '  <buildtool_depend condition="$ROS_VERSION == 2">ament_cmake</buildtool_depend>\n{}  <depend>roscpp</depend>\n'
TYPES = (
    '<build_type condition="$ROS_VERSION == 1">catkin</build_type>'
    '<build_type condition="$ROS_VERSION == 2">ament_cmake</build_type>'
)
CATKIN = "  <buildtool_depend>catkin</buildtool_depend>\n"
OLD = "<package format='2'>\n  <name>{}</name>\n  <version>1.0.0</version>\n  <description>Old.</description>\n"
OLD += "  <maintainer email='a@b.org'>Ada</maintainer>\n  <license>MIT</license>\n" + CATKIN + "</package>\n"
SOURCE = "#include <ros/ros.h>\nint main() { return 0; }\n"


def package(name: str, tools: str) -> dict[str, str]:
    text = manifest(BOTH.format(tools), "ament_cmake").replace("<build_type>ament_cmake</build_type>", TYPES)
    lines = "add_executable(node src/node.cpp)\ninstall(TARGETS node DESTINATION lib/${PROJECT_NAME})\nament_package"
    return {
        f"{name}/package.xml": text.replace("my_pkg", name),
        f"{name}/CMakeLists.txt": CMAKE.replace("my_pkg", name).replace("ament_package", lines),
        f"{name}/src/node.cpp": SOURCE,
    }


def old(*names: str) -> dict[str, str]:
    return {f"{name}/package.xml": OLD.format(name) for name in names}


@pytest.mark.parametrize(
    ("tools", "others", "levels"),
    [
        (CATKIN, old("a", "b"), {"info"}),
        (CATKIN, old("a"), {"error", "warning"}),
        (CATKIN, {**old("a", "b"), "c/package.xml": manifest("", "ament_cmake").replace("my_pkg", "c")},
         {"error", "warning"}),
        (CATKIN.replace(">", ' condition="$ROS_VERSION == 1">', 1), old("a", "b"), {"error", "warning"}),
    ],
)  # fmt: skip
def test_who_builds_the_repository(tools: str, others: dict[str, str], levels: set[str]) -> None:
    found = lint_files({**package("registration", tools), **others}, ["CMK201", "DEP203"]).findings
    assert {each.severity.value for each in found if "registration" in each.location.path} == levels

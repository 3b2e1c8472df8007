"""Keywords of one component in the command for several: who misses the program that it does not make (CMK108)."""

from __future__ import annotations

import pytest

from rospkg_cli.example import CMAKE, manifest
from rospkg_cli.testing import lint_files

LINES = """\
find_package(rclcpp REQUIRED)
find_package(rclcpp_components REQUIRED)
add_library(talker SHARED src/talker.cpp)
install(TARGETS talker DESTINATION lib)
{}
rclcpp_components_register_nodes(talker PLUGIN "my_pkg::Talker" EXECUTABLE {})
ament_package"""
SOURCE = """\
#include <rclcpp_components/register_node_macro.hpp>
RCLCPP_COMPONENTS_REGISTER_NODE(my_pkg::Talker)
"""
LAUNCH = """\
from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription([Node(package='my_pkg', executable='talker_node')])
"""
PAGE = {"README.md": "    ros2 run my_pkg talker_node\n"}
MADE = "add_executable(talker_node src/main.cpp)\ninstall(TARGETS talker_node DESTINATION lib/${PROJECT_NAME})"
SCRIPT = "install(PROGRAMS scripts/talker_node DESTINATION lib/${PROJECT_NAME})"


def told(lines: str = "", name: str = "talker_node", more: dict[str, str] | None = None) -> tuple[str, str]:
    """Return the level and the sentence."""
    files = {
        "CMakeLists.txt": CMAKE.replace("ament_package", LINES.format(lines, name)),
        "package.xml": manifest("  <depend>rclcpp</depend>\n  <depend>rclcpp_components</depend>\n", "ament_cmake"),
        "src/talker.cpp": SOURCE,
        "src/main.cpp": "int main() {}\n",
        "scripts/talker_node": "#!/bin/sh\n",
    }
    (found,) = lint_files({**files, **(more or {})}, ["CMK108"]).findings
    return found.severity.value, found.message


@pytest.mark.parametrize("more", [PAGE, {"launch/a.launch.py": LAUNCH}])
def test_a_program_that_something_starts_and_nothing_makes_is_missed(more: dict[str, str]) -> None:
    level, message = told(more=more)
    assert level == "warning"
    assert message.endswith("makes no executable; write `rclcpp_components_register_node`")


@pytest.mark.parametrize("name", ["talker_node", "${NAME_OF_SYSTEM}"])
def test_one_that_nothing_starts_is_missed_by_nobody(name: str) -> None:
    level, message = told(name=name)
    assert level == "info"
    assert (", which nothing here starts; write" in message) is (name == "talker_node")


@pytest.mark.parametrize("lines", [MADE, SCRIPT])
def test_one_that_is_made_elsewhere_is_there(lines: str) -> None:
    level, message = told(lines, more=PAGE)
    assert level == "info"
    assert message.endswith("nothing loads; remove them and `talker_node`, which is made elsewhere")


def test_no_target_is_to_be_made_twice() -> None:
    level, message = told(name="talker", more={"README.md": "    ros2 run my_pkg talker\n"})
    assert level == "warning"
    assert message.endswith("`rclcpp_components_register_node`, with a name for its executable that no target has")

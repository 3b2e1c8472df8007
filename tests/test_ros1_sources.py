"""Targets that stop at a source of ROS 1: what else they include or link is met by nobody (CMK121, CMK201, DEP105)."""

from __future__ import annotations

import pytest

from rospkg_cli.example import CMAKE, manifest
from rospkg_cli.testing import lint_files

NODE = "find_package(sensor_msgs REQUIRED)\nadd_executable(node src/node.cpp)\n"
TWO = f"{NODE}add_executable(other src/other.cpp)\n"
IMAGE, ROS = "#include <sensor_msgs/msg/image.hpp>\n", "#include <ros/ros.h>\n"
MAIN = "int main() {return 0;}\n"
NEEDS = manifest("  <depend>sensor_msgs</depend>\n", "ament_cmake")
CODES = ["CMK121", "CMK201", "DEP105"]


def told(lines: str, needs: str = NEEDS, codes: list[str] = CODES, **sources: str) -> list[tuple[str, str, str]]:
    """Return code, level and the first quoted word of each finding in a package with some sources."""
    written = {"CMakeLists.txt": CMAKE.replace("ament_package()", f"{lines}ament_package()"), "package.xml": needs}
    files = {f"src/{name}.{'hpp' if name.startswith('h_') else 'cpp'}": text for name, text in sources.items()}
    found = lint_files({**written, **files}, codes).findings
    return [(each.code, each.severity.value, each.message.split("`")[1]) for each in found]


@pytest.mark.parametrize(
    "old",
    [
        ROS,
        "#include <tf/tf.h>\n",
        "#include <geometry_msgs/PoseStamped.h>\n",
        "#include <ros/time.h>\n",
        '#include "h_old.hpp"\n',
    ],
)
def test_a_target_stops_at_a_header_of_ros_1(old: str) -> None:
    found = told(NODE, node=IMAGE + old + MAIN, h_old=ROS)
    assert [(code, level) for code, level, _ in found if code == "CMK121"] == [("CMK121", "info")]
    assert [level for code, level, _ in found if code == "CMK201"] == ["error"]


@pytest.mark.parametrize(
    "old", [f"#ifdef WITH_ROS1\n{ROS}#endif\n", "#include <ros/odd.h>\n", '#include "h_own.hpp"\n', "// ros::init\n"]
)
def test_a_target_that_is_compiled_needs_its_links(old: str) -> None:
    found = told(NODE, node=IMAGE + old + MAIN, h_own="#pragma once\n")
    assert found == [("CMK121", "warning", "sensor_msgs/msg/image.hpp")]


def test_calls_of_roscpp_stop_a_target_too() -> None:
    calls = f"{IMAGE}int main() {{ros::NodeHandle n;}}\n"
    assert told(NODE, node=calls) == [("CMK121", "info", "sensor_msgs/msg/image.hpp")]
    assert told(NODE, node=calls, h_own="namespace ros {}\n") == [("CMK121", "warning", "sensor_msgs/msg/image.hpp")]


def test_another_target_is_met_all_the_same() -> None:
    found = told(TWO, codes=["CMK121"], node=ROS + IMAGE + MAIN, other=IMAGE + MAIN)
    assert found == [("CMK121", "warning", "sensor_msgs/msg/image.hpp")]


@pytest.mark.parametrize(
    ("header", "level"),
    [("sensor_msgs/Image.h", ""), ("sensor_msgs/Odd.h", ""), ("sensor_msgs/msg/Image.hpp", "")]
    + [(f"sensor_msgs/{name}", "warning") for name in ("msg/image.hpp", "msg/image.h", "image_encodings.hpp")],
)
def test_a_header_that_a_package_can_not_have_is_no_matter_of_linking(header: str, level: str) -> None:
    found = told(NODE, codes=["CMK121"], node=f"#include <{header}>\n{MAIN}")
    assert found == ([("CMK121", level, header)] if level else [])


@pytest.mark.parametrize(
    ("header", "level"),
    [("std_msgs/String.h", ""), ("std_msgs/string.hpp", ""), ("std_msgs/msg/string.hpp", "warning")],
)
def test_nor_of_declaring(header: str, level: str) -> None:
    lines, needs = "add_executable(node src/node.cpp)\n", manifest("", "ament_cmake")
    found = told(lines, needs, ["DEP105"], node=f"#include <{header}>\n{MAIN}")
    assert found == ([("DEP105", level, "std_msgs")] if level else [])
    found = told(lines, needs, ["DEP105"], node=f"{ROS}#include <{header}>\n{MAIN}")
    assert found == ([("DEP105", "info", "std_msgs")] if level else [])


def test_what_a_target_without_ros_1_includes_too_is_met() -> None:
    lines = "add_executable(node src/node.cpp)\nadd_executable(other src/other.cpp)\n"
    text = f"#include <std_msgs/msg/string.hpp>\n{MAIN}"
    found = told(lines, manifest("", "ament_cmake"), ["DEP105"], node=ROS + text, other=text)
    assert found == [("DEP105", "warning", "std_msgs")]

"""Packages for CMake as `new` writes them, with one fault seeded at a time: `lint` names it, and nothing beside it."""

from __future__ import annotations

import pytest
from planned import plan, texts
from seeding import Files, before, both, drop, line, put, swap

from rospkg_cli.testing import lint_files

CMAKE, MANIFEST = "CMakeLists.txt", "package.xml"
NODE, LAUNCH = "src/talker.cpp", "launch/my_robot.launch.py"
MSG = "msg/Status.msg"


def nodes() -> Files:
    return texts(plan("my_robot", template="ament_cmake", nodes=("talker:publisher", "part:component")))


def interfaces() -> Files:
    return texts(plan("my_msgs", template="interfaces", msgs=("Status:std_msgs/Header header, float32 battery",)))


NODE_FAULTS = {
    "another name in project()": (swap(CMAKE, "project(my_robot)", "project(my_robto)"), "CMK001"),
    "no ament_package()": (line(CMAKE, "ament_package()"), "CMK003"),
    "exports behind ament_package()": (
        both(line(CMAKE, "ament_package()"), before(CMAKE, "ament_export_targets", "ament_package()\n")),
        "CMK004",
    ),
    "launch files that are not installed": (swap(CMAKE, "DIRECTORY launch config", "DIRECTORY config"), "CMK101"),
    "a folder that is not there": (swap(CMAKE, "DIRECTORY launch config", "DIRECTORY launch config maps"), "CMK102"),
    "a source that is not there": (swap(CMAKE, "src/talker.cpp", "src/taker.cpp"), "CMK102"),
    "an executable that is not installed": (
        swap(CMAKE, "install(TARGETS\n  talker\n  DESTINATION lib/${PROJECT_NAME})\n", ""),
        "CMK103",
    ),
    "an executable in bin": (swap(CMAKE, "DESTINATION lib/${PROJECT_NAME})", "DESTINATION bin)"), "CMK104"),
    "headers that are not installed": (line(CMAKE, "install(DIRECTORY include/"), "CMK106"),
    "a component under another name": (swap(CMAKE, "my_robot::PartNode", "my_robot::PratNode"), "CMK108"),
    "a library that is not made": (
        swap(CMAKE, "target_link_libraries(talker", "target_link_libraries(taker"),
        "CMK110",
    ),
    "an install of what is not made": (swap(CMAKE, "install(TARGETS\n  talker", "install(TARGETS\n  taker"), "CMK110"),
    "an absolute destination": (
        swap(CMAKE, "DESTINATION share/${PROJECT_NAME})", "DESTINATION /opt/my_robot)"),
        "CMK111",
    ),
    "a find_package that is not declared": (
        swap(CMAKE, "find_package(rclcpp REQUIRED)", "find_package(rclcpp REQUIRED)\nfind_package(tf2 REQUIRED)"),
        "DEP104",
    ),
    "a dependency that CMake looks for and nobody declares": (line(MANIFEST, "<depend>rclcpp</depend>"), "DEP104"),
    "a link without find_package": (line(CMAKE, "find_package(std_msgs"), "DEP107"),
    "an include of an undeclared package": (
        before(NODE, '#include "rclcpp/', "#include <geometry_msgs/msg/twist.hpp>\n"),
        "DEP105",
    ),
    "no ament_cmake": (line(MANIFEST, "<buildtool_depend>"), "XML208"),
    "an old CMake": (swap(CMAKE, "VERSION 3.20", "VERSION 3.4"), "CMK002"),
    "a launch file that starts what is not there": (
        swap(LAUNCH, "executable='talker'", "executable='taker'"),
        "LCH002",
    ),
    "CMake that is none": (swap(CMAKE, "if(BUILD_TESTING)", "if(BUILD_TESTING"), "RPK001"),
    "tests outside of BUILD_TESTING": (
        both(
            line(CMAKE, "find_package(ament_cmake_gtest"),
            before(CMAKE, "find_package(rclcpp REQUIRED)", "find_package(ament_cmake_gtest REQUIRED)\n"),
        ),
        "CMK107",
    ),
}
INTERFACE_FAULTS = {
    "a field in capitals": (swap(MSG, "float32 battery", "float32 Battery"), "IDL003"),
    "a field twice": (swap(MSG, "float32 battery", "float32 header"), "IDL003"),
    "a type that there isn't": (swap(MSG, "float32", "float"), "IDL001"),
    "a type of this package that there isn't": (swap(MSG, "float32 battery", "Battery battery"), "IDL004"),
    "a name in small letters": (
        both(put("msg/status.msg", "int32 x\n"), drop(MSG), swap(CMAKE, "Status.msg", "status.msg")),
        "IDL002",
    ),
    "a message that is not built": (put("msg/Other.msg", "int32 x\n"), "IDL005"),
    "a message that is not there": (swap(CMAKE, '"msg/Status.msg"', '"msg/Status.msg"\n  "msg/Other.msg"'), "IDL006"),
    "no DEPENDENCIES": (both(line(CMAKE, "  DEPENDENCIES"), line(CMAKE, "  std_msgs")), "IDL007"),
    "an undeclared package of fields": (line(MANIFEST, "<depend>std_msgs"), "DEP108"),
    "a message twice": (swap(CMAKE, '"msg/Status.msg"', '"msg/Status.msg"\n  "msg/Status.msg"'), "IDL009"),
    "no group": (line(MANIFEST, "<member_of_group>"), "XML305"),
    "a header of ROS 1": (swap(MSG, "std_msgs/Header header", "Header header"), "IDL001"),
}


@pytest.mark.parametrize("make", [nodes, interfaces])
def test_without_a_fault_nothing_is_said(make) -> None:
    assert [(f.code, f.message) for f in lint_files(make()).findings] == []


@pytest.mark.parametrize(
    ("make", "fault"), [*((nodes, name) for name in NODE_FAULTS), *((interfaces, name) for name in INTERFACE_FAULTS)]
)
def test_each_fault_is_named(make, fault: str) -> None:
    change, code = (NODE_FAULTS | INTERFACE_FAULTS)[fault]
    files = make()
    change(files)
    found = [(f.code, f.message) for f in lint_files(files).findings]
    assert {each for each, _ in found} == {code}, found

"""What another build, another reader or another package decides: nothing is claimed to fail there."""

from __future__ import annotations

import pytest

from rospkg_cli.example import BACKDROPS, CMAKE, existing_files, manifest
from rospkg_cli.testing import lint_files

NATIVE = existing_files(BACKDROPS["ament_cmake"])
PYTHON = existing_files(BACKDROPS["ament_python"])
ROS1 = manifest("  <buildtool_depend>catkin</buildtool_depend>\n").replace("<build_type>ament_python</build_type>", "")
DUAL = manifest("  <buildtool_depend>catkin</buildtool_depend>\n", "ament_cmake")
WRONG = (
    "cmake_minimum_required(VERSION 3.20)\nproject(my_pkg)\ninstall(FILES no.xml DESTINATION share)\nament_package()\n"
)
ROBOT = '<robot xmlns:xacro="http://www.ros.org/wiki/xacro" name="r">{}</robot>\n'
CHOSEN = """\
<xacro:arg name="sim" default="gz"/>
<xacro:if value="${'$(arg sim)' == 'gz'}"><xacro:property name="a" value="1"/></xacro:if>
<link name="base"/><link name="tip_${a}"/>
<joint name="j" type="fixed"><parent link="base"/><child link="tip_${a}"/></joint>
"""
URDF = CMAKE.replace("ament_package", "install(DIRECTORY urdf DESTINATION share/${PROJECT_NAME})\nament_package")
MESH = "<{0}><a>$(find my_pkg)/config/no.yaml</a></{0}>"
STARTED = '<launch>\n  <node pkg="my_pkg" exec="talker"/>\n</launch>\n'
GAZEBO = "  <node pkg='gazebo_ros' exec='spawn_entity.py'/>\n"


def levels(code: str, files: dict[str, str]) -> list[str]:
    return [each.severity.value for each in lint_files(files, [code]).findings]


@pytest.mark.parametrize(
    ("package", "found"), [(ROS1, []), (DUAL, ["error"]), (manifest("", "ament_cmake"), ["error"])]
)
def test_packages_for_ros1_take_no_part(package: str, found: list[str]) -> None:
    assert levels("CMK102", {"package.xml": package, "CMakeLists.txt": WRONG}) == found


def test_manifests_and_broken_files_for_ros1_are_told() -> None:
    files = {"package.xml": ROS1.replace("</version>", "a</version>"), "CMakeLists.txt": "project(\n"}
    assert levels("XML103", files) == ["error"]
    assert levels("RPK001", files) == ["error"]


def test_xacro_fills_in_arguments_inside_of_expressions() -> None:
    files = {**NATIVE, "CMakeLists.txt": URDF, "urdf/r.urdf.xacro": ROBOT.format(CHOSEN)}
    assert lint_files(files, ["URD001"]).findings == ()


@pytest.mark.parametrize(
    ("call", "count"),
    [
        ("agnocast_register_node(talker_lib PLUGIN a::B)", 0),
        ("my_wrapper(talker_lib EXECUTABLE talker)", 0),
        ("vendor_add_executable(talker a.cpp)", 0),
        ("vendor_add_library(talker_lib a.cpp)", 1),
        ("", 1),
    ],
)
def test_commands_of_other_packages_may_make_programs(call: str, count: int) -> None:
    text = CMAKE.replace(
        "ament_package", f"install(DIRECTORY launch DESTINATION share/${{PROJECT_NAME}})\n{call}\nament_package"
    )
    files = {
        "package.xml": manifest("  <exec_depend>ros2launch</exec_depend>\n", "ament_cmake"),
        "CMakeLists.txt": text,
        "launch/a.launch.xml": STARTED,
    }
    assert len(lint_files(files, ["LCH002"]).findings) == count


@pytest.mark.parametrize(
    ("path", "count"),
    [
        ("my_pkg/gen_launch.py", 0),
        ("my_pkg/gen.launch.py", 1),
        ("launch/gen_launch.py", 1),
        ("a/launch/x_launch.py", 1),
    ],
)
def test_a_module_that_writes_launch_files_is_none(path: str, count: int) -> None:
    assert len(lint_files({**PYTHON, path: "def gen_launch():\n    return []\n"}, ["LCH001"]).findings) == count


@pytest.mark.parametrize(("tag", "is_told"), [("gazebo", True), ("plugin", True), ("link", False)])
def test_what_gazebo_alone_reads(tag: str, is_told: bool) -> None:
    files = {**NATIVE, "CMakeLists.txt": URDF, "urdf/r.urdf.xacro": ROBOT.format(MESH.format(tag))}
    files |= {"launch/a.launch.xml": f"<launch>\n  <arg name='m' default='r.urdf.xacro'/>\n{GAZEBO}</launch>\n"}
    (finding,) = lint_files(files, ["URD002"]).findings
    assert (finding.severity.value, ", in Gazebo alone" in finding.message) == ("warning", is_told)


LIBRARY = "add_library(a a.cpp)\ninstall(TARGETS a DESTINATION lib)\n"
TESTS = "install(TARGETS test_a RUNTIME DESTINATION lib/${PROJECT_NAME})\n"


@pytest.mark.parametrize(
    ("rest", "level"),
    [
        ("install(TARGETS talker DESTINATION lib/${PROJECT_NAME})\nadd_executable(talker a.cpp)\n", "error"),
        ("install(PROGRAMS a.py DESTINATION lib/${PROJECT_NAME})\n", "error"),
        ("rclcpp_components_register_node(a PLUGIN a::B EXECUTABLE talker)\n", "error"),
        ("add_library(a a.cpp)\n", "warning"),
        (f"{LIBRARY}add_executable(test_a test/test_a.cpp)\n{TESTS}", "warning"),
        (f"{LIBRARY}add_executable(demo demo.cpp)\n", "warning"),
        (f"{LIBRARY}add_executable(demo demo.cpp)\n{TESTS.replace('test_a', 'demo')}", "error"),
        (
            f"{LIBRARY}add_executable(demo demo.cpp)\ninstall(TARGETS $ENV{{PROGRAMS}} DESTINATION lib/my_pkg)\n",
            "error",
        ),
        ("add_executable(demo demo.cpp)\nadd_library(a a.cpp)\n", "error"),
        (f"{LIBRARY}ament_add_gtest(test_a src/test_a.cpp)\n", "warning"),
        (f"if(WITH_TESTS)\n  ament_add_gmock(test_a src/test_a.cpp)\nendif()\n{LIBRARY}", "warning"),
        ("ament_add_gtest(test_a test/test_a.cpp)\nadd_executable(demo demo.cpp)\nadd_library(a a.cpp)\n", "error"),
    ],
)
def test_a_package_without_programs_lacks_its_build_type(rest: str, level: str) -> None:
    text = manifest("", "ament_cmake").replace("<build_type>ament_cmake</build_type>", "")
    files = {"package.xml": text, "CMakeLists.txt": CMAKE.replace("ament_package", f"{rest}ament_package"), "a.cpp": ""}
    assert levels("XML301", files) == [level]
    assert levels("XML301", {**files, "launch/a.launch.xml": "<launch/>\n"}) == ["error"]


@pytest.mark.parametrize(("program", "level"), [("test_a", "error"), ("test_b", "warning")])
def test_a_test_that_a_page_runs_is_to_be_found(program: str, level: str) -> None:
    text = manifest("", "ament_cmake").replace("<build_type>ament_cmake</build_type>", "")
    lines = f"{LIBRARY}add_executable(test_a test/test_a.cpp)\n{TESTS}"
    files = {"package.xml": text, "CMakeLists.txt": CMAKE.replace("ament_package", f"{lines}ament_package")}
    files |= {"README.md": f"    ros2 run my_pkg {program}\n", "a.cpp": "", "test/test_a.cpp": "int main() {}\n"}
    assert levels("XML301", files) == [level]


FOR_BOTH = "project(my_pkg)\nfind_package(ament_cmake QUIET)\nif(ament_cmake_FOUND)\n{}elseif(CATKIN_X)\n{}endif()\n"
CATKIN = "  find_package(catkin REQUIRED)\n  catkin_package()\n"
BOTH_TOOLS = (
    '  <buildtool_depend condition="$ROS_VERSION == 1">catkin</buildtool_depend>\n'
    '  <buildtool_depend condition="$ROS_VERSION == 2">ament_cmake</buildtool_depend>\n'
)


@pytest.mark.parametrize(
    ("native", "catkin", "expected"),
    [
        ('  message(STATUS "ignored")\n', CATKIN, []),
        ("  ament_package()\n", CATKIN, ["info"]),
        ('  message(WARNING "use npm")\n  ament_package()\n', "  catkin_package()\n", ["info"]),
        ("  add_executable(a a.cpp)\n  ament_package()\n", CATKIN, ["error"]),
        ("  add_library(a a.cpp)\n  ament_package()\n", CATKIN, ["warning"]),
        ("  install(PROGRAMS a.cpp DESTINATION lib/my_pkg)\n", "", ["error"]),
    ],
)
def test_what_cmake_leaves_to_ros_1(native: str, catkin: str, expected: list[str]) -> None:
    text = manifest(BOTH_TOOLS, "ament_cmake").replace("<build_type>ament_cmake</build_type>", "")
    files = {"package.xml": text, "CMakeLists.txt": FOR_BOTH.format(native, catkin), "a.cpp": ""}
    assert levels("XML301", files) == expected

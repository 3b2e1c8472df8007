"""What people forget to declare, and what is judged of a package that names no build type."""

from __future__ import annotations

import pytest

from rospkg_cli.example import BACKDROPS, CMAKE, existing_files, manifest
from rospkg_cli.testing import lint_files

PYTHON = existing_files(BACKDROPS["ament_python"])
CPP = existing_files(BACKDROPS["ament_cmake"])


def told(files: dict[str, str], code: str) -> list[str]:
    return [f"{finding.severity.value} {finding.message}" for finding in lint_files(files, [code]).findings]


def launched(name: str, text: str, *needs: str) -> list[str]:
    body = "".join(f"  <exec_depend>{need}</exec_depend>\n" for need in ("tf2_ros", *needs))
    return told({**PYTHON, "package.xml": manifest(body), f"launch/{name}": text}, "DEP103")


XML = '<launch><node pkg="tf2_ros" exec="tf2_echo"/></launch>\n'
YAML = "launch:\n- node:\n    pkg: tf2_ros\n    exec: tf2_echo\n"


@pytest.mark.parametrize("kind, text", [("xml", XML), ("yaml", YAML)])
def test_what_reads_a_launch_file_is_declared(kind: str, text: str) -> None:
    (message,) = launched(f"a.launch.{kind}", text, "launch_ros")
    assert message.startswith(f"info this launch file needs `launch_{kind}`, which nothing in package.xml brings")
    assert launched(f"a.launch.{kind}", text, "ros2launch") == []
    assert launched(f"a.launch.{kind}", text, "launch_ros", f"launch_{kind}") == []
    assert launched(f"a.launch.{kind}", text) == []


def test_a_launch_file_that_starts_nothing_needs_no_reader() -> None:
    assert launched("a.launch.xml", "<launch/>\n", "launch_ros") == []


def required(lines: str, body: str = "") -> list[str]:
    files = {**CPP, "CMakeLists.txt": CMAKE.replace("ament_package", f"{lines}\nament_package")}
    return told({**files, "package.xml": manifest(body, "ament_cmake")}, "DEP104")


FIND = "find_package({} REQUIRED)"
USE = "\nament_target_dependencies(node {})"


def test_undeclared_interfaces_that_nobody_knows() -> None:
    lines = FIND.format("acme_msgs")
    (message,) = required(f"{lines}\n{lines}")
    assert message.startswith("info CMake requires `acme_msgs`")


def test_a_package_that_ament_is_handed() -> None:
    (message,) = required((FIND + USE).format("acme_arm", "acme_arm"))
    assert message.startswith("info CMake requires `acme_arm`")


@pytest.mark.parametrize(
    "lines, body",
    [
        (FIND.format("acme_arm"), ""),
        ("find_package(acme_msgs)", ""),
        ("if(X)\n  find_package(acme_msgs REQUIRED)\nendif()", ""),
        ("if(BUILD_TESTING)\n  find_package(acme_msgs REQUIRED)\nendif()", ""),
        (FIND.format("acme_msgs"), "  <depend>acme_msgs</depend>\n"),
        (FIND.format("acme_msgs"), "  <depend>amce_msgs</depend>\n"),
        ((FIND + USE).format("acme", "acme"), ""),
        ((FIND + USE).format("sdl2_custom", "sdl2_custom"), "  <depend>sdl2_vendor</depend>\n"),
    ],
)
def test_what_may_be_no_package_of_ros_or_is_declared(lines: str, body: str) -> None:
    assert required(lines, body) == []


CONTROLLER = "controller_manager:\n  ros__parameters:\n    arm:\n      type: acme_controllers/Arm\n"
START = '<launch><node pkg="{}" exec="spawner"/></launch>\n'


def loaded(text: str, package: str = "controller_manager", body: str = "") -> list[str]:
    files = {**PYTHON, "test/arm.yaml": text, "test/arm.launch.xml": START.format(package)}
    return told({**files, "package.xml": manifest(body)}, "DEP106")


def test_controllers_of_tests_are_declared() -> None:
    text = CONTROLLER.replace("acme_controllers/Arm", "joint_state_broadcaster/JointStateBroadcaster")
    (message,) = loaded(text)
    assert "`joint_state_broadcaster` is not declared" in message
    assert message.endswith("add <test_depend>joint_state_broadcaster</test_depend>")
    assert loaded(text, body="  <test_depend>joint_state_broadcaster</test_depend>\n") == []
    assert loaded(text, "rviz2") == []
    assert loaded(CONTROLLER) == []


@pytest.mark.parametrize(
    "tool, export, found",
    [
        ("ament_cmake", "", ["rclcpp"]),
        ("ament_cmake_ros", "", ["rclcpp"]),
        ("rosidl_default_generators", "", []),
        ("ament_cmake", '<build_type condition="$ROS_VERSION == 1">catkin</build_type>', []),
    ],
)
def test_a_package_without_a_build_type_is_judged_as_its_build_tool_says(tool: str, export: str, found: list) -> None:
    text = manifest(build_type="ament_cmake").replace("<build_type>ament_cmake</build_type>", export)
    files = {**CPP, "package.xml": text.replace(">ament_cmake<", f">{tool}<")}
    files["CMakeLists.txt"] = CMAKE.replace("ament_package", "find_package(rclcpp REQUIRED)\nament_package")
    assert [each.split("`")[1] for each in told(files, "DEP104")] == found

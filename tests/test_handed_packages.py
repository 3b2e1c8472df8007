"""What is handed to ament, included or named and is not found: packages under another name, or known to siblings."""

from __future__ import annotations

import pytest

from rospkg_cli.example import CMAKE, manifest
from rospkg_cli.testing import lint_files

MAIN = "int main() {return 0;}\n"
NODE = "add_executable(node src/node.cpp)\n"
INSTALLED = "install(TARGETS node DESTINATION lib/${PROJECT_NAME})\n"


def said(code: str, lines: str, needs: str = "", source: str = MAIN, **others: str) -> list[str]:
    """Return level and first name of each finding on a package with a node, with packages that need something."""
    files = {
        "a/CMakeLists.txt": CMAKE.replace("my_pkg", "a").replace("ament_package()", f"{lines}ament_package()"),
        "a/package.xml": manifest(needs, "ament_cmake", "a"),
        "a/src/node.cpp": source,
    }
    for name, body in others.items():
        files |= {
            f"{name}/package.xml": manifest(body, "ament_cmake", name),
            f"{name}/CMakeLists.txt": CMAKE.replace("my_pkg", name),
        }
    found = lint_files(files, [code]).findings
    return [f"{each.severity.value} {each.message.split('`')[1]}" for each in found if each.package == "a"]


def handed(words: str, finds: str) -> list[str]:
    finds = "".join(f"find_package({name} REQUIRED)\n" for name in finds.split())
    return said("CMK117", f"{finds}{NODE}ament_target_dependencies(node {words})\n")


@pytest.mark.parametrize(
    "words, finds, expected",
    [
        ("fast_thing", "FastThing", ["info find_package"]),
        ("FastThing", "fast_thing", ["info find_package"]),
        ("RCLCPP", "rclcpp", ["error find_package"]),
        ("old_fast_thing_vendor", "fast_thing_vendor", ["info find_package"]),
        ("thing_vendor", "fast_thing_vendor", ["info find_package"]),
        ("rclpcp", "rclcpp", ["error find_package"]),
        ("std_mgs", "std_msgs", ["error find_package"]),
        ("st_mgss", "std_msgs", ["info find_package"]),
        ("geometri_mgss", "geometry_msgs", ["error find_package"]),
        ("acme_cam_msgs", "acme_arm_msgs", ["info find_package"]),
        ("old_fast_thing", "fast_thing", []),
        ("thing_vendor", "fast_thing_vendor slow_thing_vendor", []),
        ("rclcpp", "rclcpp", []),
    ],
)
def test_a_package_under_another_name_than_it_is_found_by(words: str, finds: str, expected: list[str]) -> None:
    assert handed(words, finds) == expected


@pytest.mark.parametrize(
    "words, expected",
    [
        ("PRIVATE rclcpp", ["error ament_target_dependencies"]),
        ("rclcpp PUBLIC std_msgs", ["error ament_target_dependencies"]),
        ("PUBLIC rclcpp", []),
        ("SYSTEM PUBLIC rclcpp std_msgs", []),
        ("INTERFACE rclcpp", []),
        ("${MORE} PUBLIC rclcpp", []),
    ],
)
def test_keywords_that_ament_does_not_take(words: str, expected: list[str]) -> None:
    assert handed(words, "rclcpp std_msgs") == expected


def test_keywords_under_a_condition() -> None:
    call = "if(X_FOUND)\n  ament_target_dependencies(node PRIVATE rclcpp)\nendif()\n"
    assert said("CMK117", f"find_package(rclcpp REQUIRED)\n{NODE}{call}") == []


INCLUDED = f"#include <acme_parts/parts.hpp>\n{MAIN}"


def test_headers_of_a_package_that_only_siblings_know() -> None:
    needs = "  <depend>acme_parts</depend>\n"
    assert said("DEP105", NODE, source=INCLUDED) == []
    assert said("DEP105", NODE, source=INCLUDED, other=needs) == ["warning acme_parts"]
    assert said("DEP105", NODE, needs, source=INCLUDED, other=needs) == []
    single = INCLUDED.replace("acme_parts", "acme")
    assert said("DEP105", NODE, source=single, other=needs.replace("acme_parts", "acme")) == []


def test_a_found_package_is_no_other_of_a_longer_name() -> None:
    needs = "  <depend>sensor_msgs</depend>\n  <depend>tf2_sensor_msgs</depend>\n"
    source = f"#include <tf2_sensor_msgs/tf2_sensor_msgs.hpp>\n{MAIN}"
    finds = "find_package(sensor_msgs REQUIRED)\n"
    assert said("DEP107", finds + NODE, needs, source) == ["info tf2_sensor_msgs"]
    assert said("DEP107", finds.replace("(s", "(tf2_s") + NODE, needs, source) == []


@pytest.mark.parametrize(("lines", "found"), [(NODE, ["warning rclcpp"]), ("", []), ("# " + NODE, [])])
def test_what_nothing_compiles_needs_no_package(lines: str, found: list[str]) -> None:
    source = f"#include <rclcpp/rclcpp.hpp>\n{MAIN}"
    assert said("DEP107", lines, "  <depend>rclcpp</depend>\n", source) == found


@pytest.mark.parametrize("naming", ["set(NODES node)\n", "list(APPEND NODES node)\n", "message(STATUS node)\n"])
def test_a_variable_that_names_a_target_uses_nothing(naming: str) -> None:
    assert said("CMK103", NODE + naming) == ["info node"]
    assert said("CMK103", f"{NODE}{naming}{INSTALLED}") == []
    assert said("CMK103", f"{NODE}set(NODES node)\ninstall(TARGETS ${{NODES}} DESTINATION lib/a)\n") == []


MADE = """\
from launch import LaunchDescription
from nav2_common.launch import {maker}


def generate_launch_description():
    return LaunchDescription([{maker}(package='nav2_amcl', {key}='amcl')])
"""


@pytest.mark.parametrize(
    "maker, key, expected",
    [
        ("Node", "executable", ["nav2_amcl"]),
        ("Node", "node_executable", ["nav2_amcl"]),
        ("make_node", "plugin", ["nav2_amcl"]),
        ("Node", "name", []),
    ],
)
def test_nodes_that_a_class_of_another_package_makes(maker: str, key: str, expected: list[str]) -> None:
    files = {
        "package.xml": manifest("  <exec_depend>nav2_common</exec_depend>\n", "ament_cmake"),
        "CMakeLists.txt": CMAKE.replace(
            "ament_package", "install(DIRECTORY launch DESTINATION share/my_pkg)\nament_package"
        ),
        "launch/a.launch.py": MADE.format(maker=maker, key=key),
    }
    found = [each.message.split("`")[1] for each in lint_files(files, ["DEP103"]).findings]
    assert [name for name in found if name.startswith("nav2")] == expected


@pytest.mark.parametrize(
    ("words", "finds", "expected"),
    [
        ("pcl", "PCL", ["info pcl"]),
        ("boost", "Boost", ["info boost"]),
        ("EIGEN3", "Eigen3", []),
        ("pcl", "PCL pcl", []),
        ("pcl", "pcl_ros", []),
        ("rclcpp", "RCLCPP rclcpp", []),
    ],
)
def test_a_library_in_other_letters_than_it_is_found_by(words: str, finds: str, expected: list[str]) -> None:
    """It may be declared, as a key of rosdep has small letters."""
    lines = "".join(f"find_package({name} REQUIRED)\n" for name in finds.split())
    lines += f"{NODE}ament_target_dependencies(node {words})\n"
    assert said("CMK117", lines, f"  <depend>{words}</depend>\n") == expected
    assert said("CMK117", f"set({words}_FOUND ON)\n{lines}", f"  <depend>{words}</depend>\n") == []
    assert said("CMK117", f"include(${{MORE}})\n{lines}", f"  <depend>{words}</depend>\n") == []


@pytest.mark.parametrize(
    "name, declared, expected",
    [
        ("std_mgs", "std_msgs", ["error std_mgs"]),
        ("geometri_mgss", "geometry_msgs", ["error geometri_mgss"]),
        ("gemetry_msgs", "std_msgs", ["info gemetry_msgs"]),
        ("goemetry_msgs", "std_msgs", ["error goemetry_msgs"]),
        ("st_mgss", "std_msgs", ["info st_mgss"]),
    ],
)
def test_what_package_xml_declares_is_meant(name: str, declared: str, expected: list[str]) -> None:
    lines, body = f"find_package({name} REQUIRED)\n", f"  <depend>{declared}</depend>\n"
    assert said("CMK117", lines, body) == expected
    outside = "list(APPEND CMAKE_MODULE_PATH ${WHEREVER}/cmake)\n"
    assert said("CMK117", outside + lines, body) == [each.replace("error", "info") for each in expected]


@pytest.mark.parametrize(
    "lines, level",
    [
        ("find_package(Eigen3::Eigen REQUIRED)\n", "error"),
        ("find_package(Eigen3::Eigen)\n", "info"),
        ("find_package(Eigen3::Eigen)\n{NODE}target_link_libraries(node Eigen3::Eigen)\n", "warning"),
        (
            "find_package(Eigen3::Eigen)\nfind_package(Eigen3)\n{NODE}target_link_libraries(node Eigen3::Eigen)\n",
            "info",
        ),
        ("find_package(a REQUIRED)\n", "warning"),
        ("set(CMAKE_PREFIX_PATH ${WHEREVER})\nfind_package(a REQUIRED)\n", "info"),
    ],
)
def test_targets_and_the_package_itself_are_looked_for(lines: str, level: str) -> None:
    (found,) = said("CMK117", lines.replace("{NODE}", NODE))
    assert found.startswith(level)


@pytest.mark.parametrize(
    ("target", "level"),
    [("rclcpp::rclpcp", "error"), ("tf2_ros::tf2_rxx", "info"), ("tf2::tf2", "")],
)
def test_a_target_that_is_nearly_one_of_a_package(target: str, level: str) -> None:
    lines = f"find_package(rclcpp REQUIRED)\nfind_package(tf2_ros REQUIRED)\n{NODE}"
    found = said("CMK110", f"{lines}target_link_libraries(node {target})\n")
    assert [each.partition(" ")[0] for each in found] == [level] * bool(level)


@pytest.mark.parametrize(
    "call, level", [("ament_export_dependencies(", "info"), (f"{NODE}ament_target_dependencies(node ", "error")]
)
def test_names_that_are_run_together(call: str, level: str) -> None:
    lines = f"find_package(rclcpp REQUIRED)\nfind_package(std_msgs REQUIRED)\n{call}rclcppstd_msgs)\n"
    assert said("CMK110", lines) == [f"{level} rclcppstd_msgs"]

"""What is not declared and only some of the distributions have that the repository names (DEP101, DEP103, DEP116)."""

from __future__ import annotations

import pytest

from rospkg_cli.checks.depends.split_distributions import with_newest
from rospkg_cli.example import BACKDROPS, CMAKE, existing_files, manifest
from rospkg_cli.finding import Edit, Finding, Operation
from rospkg_cli.testing import lint_files

LAUNCH = """\
from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription([Node(package='{}', executable='spawn_entity.py')])
"""
ON = existing_files(BACKDROPS["ament_python"])
NEEDS = "  <exec_depend>ros2launch</exec_depend>\n"
OLD = manifest(NEEDS).replace('format="3"', 'format="2"').replace("package_format3", "package_format2")


def found(page: str, package: str = "gazebo_ros", text: str = "", **more: str) -> Finding:
    files = {"package.xml": text or manifest(NEEDS), "launch/a.launch.py": LAUNCH.format(package), "README.md": page}
    (finding,) = lint_files({**ON, **files, **more}, ["DEP103"]).findings
    return finding


def text_of(operations: tuple[Operation, ...]) -> str:
    return "".join(each.text for each in operations if isinstance(each, Edit))


@pytest.mark.parametrize(
    ("page", "level", "safety", "condition"),
    [
        ("A robot.\n", "warning", "safe", ""),
        ("For Humble.\n", "warning", "safe", ""),
        ("For Galactic and Humble.\n", "warning", "safe", ""),
        ("For Humble and Jazzy.\n", "info", "safe", ' condition="$ROS_DISTRO == humble"'),
        ("For Jazzy.\n", "warning", "unsafe", ""),
    ],
)
def test_a_package_that_newer_distributions_lack(page: str, level: str, safety: str, condition: str) -> None:
    finding = found(page)
    fix = finding.fix
    assert fix is not None
    assert (finding.severity.value, fix.safety.value) == (level, safety)
    assert f"add <exec_depend{condition}>gazebo_ros</exec_depend>" in finding.message
    assert ("jazzy, which the repository names, lacks it" in finding.message) == ("Jazzy" in page)
    assert ("list its repository" in finding.message) == (page == "For Jazzy.\n")
    assert f"<exec_depend{condition}>gazebo_ros</exec_depend>" in text_of(fix.operations)


def test_format_2_has_no_conditions() -> None:
    finding = found("For Humble and Jazzy.\n", text=OLD)
    fix = finding.fix
    assert fix is not None
    assert (finding.severity.value, fix.safety.value) == ("info", "unsafe")
    assert "<exec_depend>gazebo_ros<" in text_of(fix.operations)


@pytest.mark.parametrize("name", ["rviz2", "ros_gz_sim"])
def test_a_package_that_all_of_them_have(name: str) -> None:
    finding = found("For Humble and Jazzy.\n", name)
    fix = finding.fix
    assert fix is not None
    assert (finding.severity.value, fix.safety.value) == ("warning", "safe")
    assert "condition" not in finding.message


@pytest.mark.parametrize(
    ("having", "expected"),
    [
        (["humble"], {"humble"}),
        (["humble", "jazzy"], {"humble", "jazzy"}),
        (["humble", "jazzy", "kilted"], {"humble", "jazzy", "kilted", "lyrical", "rolling"}),
        (["rolling"], {"rolling"}),
    ],
)
def test_what_the_newest_lack_is_not_released_yet(having: list[str], expected: set[str]) -> None:
    assert with_newest(having) == expected


def test_a_build_stops_where_a_package_is_missing_whoever_lacks_it() -> None:
    cmake = CMAKE.replace("ament_package", "find_package(gazebo_ros REQUIRED)\nament_package")
    files = {
        "package.xml": manifest("", "ament_cmake"),
        "CMakeLists.txt": cmake,
        "README.md": "For Humble and Jazzy.\n",
    }
    (finding,) = lint_files(files, ["DEP104"]).findings
    assert finding.severity.value == "warning"
    assert '<depend condition="$ROS_DISTRO == humble">gazebo_ros</depend>' in finding.message.replace("build_", "")

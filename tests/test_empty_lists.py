"""PRM004: at an empty list a node in C++ stops, and is shown to read the block, or else it is an info.

What rcl refuses stops nobody where only a launch file that is not installed gives the file to nodes (PRM001, PRM004).
"""

from __future__ import annotations

import pytest

from rospkg_cli.example import CMAKE, manifest
from rospkg_cli.testing import lint_files

INSTALL = CMAKE.replace("ament_package", "install(DIRECTORY launch config DESTINATION share/my_pkg)\nament_package")
LAUNCH = """\
import os
from ament_index_python.packages import get_package_prefix
from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    config = os.path.join(get_package_prefix('my_pkg'), '..', 'src', 'my_pkg', 'config', 'a.yaml')
    return LaunchDescription([Node(package='{}', executable='{}', name='{}', parameters=[config])])
"""
PASSED = """\
<launch>
  <include file="$(find-pkg-share {})/launch/{}">
    <arg name="params_file" value="$(find-pkg-share my_pkg)/config/a.yaml"/>
  </include>
</launch>
"""
NATIVE = {"native/package.xml": manifest("", "ament_cmake", "native")}
PYTHON = {"native/package.xml": manifest("", "ament_python", "native"), "native/setup.py": ""}


@pytest.mark.parametrize(
    ("name", "launch", "more", "level"),
    [
        ("a.launch.py", LAUNCH.format("native", "talker", "arm"), NATIVE, "warning"),
        ("a.launch.py", LAUNCH.format("native", "arm", "other"), NATIVE, "warning"),
        ("a.launch.py", LAUNCH.format("native", "talker", "other"), NATIVE, "info"),
        ("a.launch.py", LAUNCH.format("native", "talker", "arm"), PYTHON, "info"),
        ("a.launch.py", LAUNCH.format("driver_of_somebody", "arm", "arm"), {}, "info"),
        ("a.launch.py", LAUNCH.format("turtlesim", "turtlesim_node", "arm"), {}, "warning"),
        ("a.launch.xml", PASSED.format("nav2_bringup", "navigation_launch.py"), {}, "info"),
    ],
)
def test_who_reads_the_block(name: str, launch: str, more: dict[str, str], level: str) -> None:
    files = {**more, f"my_pkg/launch/{name}": launch}
    assert found(files, "arm") == [level]


@pytest.mark.parametrize(("package", "level"), [("nav2_bringup", "warning"), ("my_pkg", "info")])
def test_a_well_known_node_behind_an_include(package: str, level: str) -> None:
    files = {
        "my_pkg/launch/a.launch.xml": PASSED.format(package, "b.launch.xml"),
        "my_pkg/launch/b.launch.xml": "<launch/>",
    }
    assert found(files, "collision_monitor") == [level]


@pytest.mark.parametrize(("installed", "level"), [("launch config", "error"), ("config", "info")])
@pytest.mark.parametrize(
    "values", ["arm:\n  rate: 1\n/**:\n  ros__parameters: {}\n", "arm:\n  ros__parameters:\n    a: *b\n"]
)
def test_a_file_for_nodes_that_nobody_starts(installed: str, level: str, values: str) -> None:
    given = '<node pkg="native" exec="arm"><param from="$(find-pkg-share my_pkg)/config/a.yaml"/></node>'
    files = {
        "package.xml": manifest("", "ament_cmake"),
        "CMakeLists.txt": INSTALL.replace("launch config", installed),
        "config/a.yaml": values,
        "launch/a.launch.xml": f"<launch>{given}</launch>\n",
    }
    levels = [each.severity.value for each in lint_files(files, ["PRM001", "PRM004"]).findings]
    assert levels == [level]


def found(files: dict[str, str], node: str) -> list[str]:
    own = {
        "my_pkg/package.xml": manifest("", "ament_cmake"),
        "my_pkg/CMakeLists.txt": INSTALL,
        "my_pkg/config/a.yaml": f"{node}:\n  ros__parameters:\n    names: []\n",
    }
    return [each.severity.value for each in lint_files({**own, **files}, ["PRM004"]).findings]

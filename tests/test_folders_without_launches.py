"""A folder `launch/` in which nothing is a launch file of ROS 2 need not be installed (CMK101, SET206)."""

from __future__ import annotations

import pytest

from rospkg_cli.example import manifest
from rospkg_cli.testing import lint_files

CMAKE = "cmake_minimum_required(VERSION 3.8)\nproject(my_pkg)\nfind_package(ament_cmake REQUIRED)\nament_package()\n"
SETUP = """\
from setuptools import setup

setup(name='my_pkg', version='0.1.0', packages=['my_pkg'], data_files=[('share/my_pkg', ['package.xml'])])
"""
LAUNCH = """\
from launch import LaunchDescription


def generate_launch_description():
    return LaunchDescription([])
"""
OLD = "#!/usr/bin/env python3\nimport rospy\n\nif __name__ == '__main__':\n    rospy.init_node('move')\n"
ROS1 = '<launch>\n  <node pkg="my_pkg" type="move" name="move"/>\n</launch>\n'
ROS2 = '<launch>\n  <node pkg="my_pkg" exec="move"/>\n</launch>\n'


def told(build_type: str, page: str = "", **files: str) -> list[str]:
    named = {f"launch/{name.replace('_dot_', '.')}": text for name, text in files.items()}
    build = {"setup.py": SETUP, "my_pkg/__init__.py": ""} if build_type == "ament_python" else {"CMakeLists.txt": CMAKE}
    package = {"package.xml": manifest("", build_type), **build, **named, "README.md": page}
    return [each.severity.value for each in lint_files(package, ["CMK101", "SET206"]).findings]


@pytest.mark.parametrize("build_type", ["ament_cmake", "ament_python"])
@pytest.mark.parametrize(
    ("files", "is_told"),
    [
        ({"a_launch_dot_py": LAUNCH}, True),
        ({"a_launch_dot_py": OLD}, False),
        ({"a_launch_dot_py": OLD.replace("rospy", "rclpy").replace("init_node('move')", "init()")}, False),
        ({"a_launch_dot_py": "import roslaunch\n"}, False),
        ({"a_launch_dot_py": OLD, "b_launch_dot_py": LAUNCH}, True),
        ({"a_launch_dot_py": f"{OLD}\nfrom launch.actions import LogInfo\n"}, True),
        ({"a_launch_dot_py": "from my_pkg.starts import generate_launch_description\nimport rclpy\n"}, True),
        ({"a_launch_dot_py": "from my_pkg.starts import *\nimport rclpy\n"}, True),
        ({"a_launch_dot_py": "generated = 1\n"}, True),
        ({"a_dot_launch": ROS1}, False),
        ({"a_dot_launch_dot_xml": ROS1}, False),
        ({"a_dot_launch_dot_xml": ROS2}, True),
    ],
)
def test_a_folder_is_asked_for_by_its_launch_files(build_type: str, files: dict[str, str], is_told: bool) -> None:
    assert bool(told(build_type, **files)) is is_told


FOXY = LAUNCH.replace(
    "import LaunchDescription", "import LaunchDescription\nfrom launch_ros.actions import Node"
).replace("[]", "[Node(package='my_pkg', node_executable='move')]")
TODAY = FOXY.replace("node_executable", "executable")


@pytest.mark.parametrize("build_type", ["ament_cmake", "ament_python"])
@pytest.mark.parametrize(
    ("files", "page", "level"),
    [
        ({"a_dot_launch_dot_py": FOXY}, "", "info"),
        ({"a_dot_launch_dot_py": FOXY}, "For ROS 2 Jazzy.\n", "info"),
        ({"a_dot_launch_dot_py": FOXY}, "For ROS 2 Foxy.\n", "warning"),
        ({"foxy_dot_launch_dot_py": FOXY}, "", "warning"),
        ({"a_dot_launch_dot_py": FOXY}, "`ros2 launch my_pkg a.launch.py`\n", "error"),
        ({"a_dot_launch_dot_py": TODAY}, "", "warning"),
        ({"a_dot_launch_dot_py": FOXY, "b_dot_launch_dot_py": TODAY}, "", "warning"),
        ({"a_dot_launch_dot_py": FOXY, "b_dot_launch_dot_xml": ROS2}, "", "warning"),
    ],
)
def test_launch_files_that_launch_stops_in(build_type: str, files: dict[str, str], page: str, level: str) -> None:
    assert told(build_type, page, **files) == [level]

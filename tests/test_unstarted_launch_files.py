"""Launch files that nothing installs: their faults are met by who starts them by their path, and by nobody else."""

from __future__ import annotations

import pytest

from rospkg_cli.example import manifest
from rospkg_cli.testing import lint_files

NODE = """\
from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription([Node(package='tf2_ros', executable='static_transform_publisher', name='a')])
"""
INCLUDE = """\
from launch import LaunchDescription
from launch.actions import IncludeLaunchDescription
from launch.launch_description_sources import PythonLaunchDescriptionSource
from launch_ros.substitutions import FindPackageShare
from os.path import dirname, join


def generate_launch_description():
    return LaunchDescription([IncludeLaunchDescription(PythonLaunchDescriptionSource({}))])
"""
BY_PATH = INCLUDE.format("join(dirname(__file__), 'a.launch.py')")
BY_SHARE = INCLUDE.format("[FindPackageShare('my_pkg'), '/launch/a.launch.py']")
UNSTARTED = "; nothing installs this file, or starts it by its path"
INSTALL = "install(DIRECTORY launch DESTINATION share/${PROJECT_NAME})\n"
CMAKE = "cmake_minimum_required(VERSION 3.8)\nproject(my_pkg)\nfind_package(ament_cmake REQUIRED)\n{}ament_package()\n"


def found(code: str = "LCH022", **files: str) -> list[tuple[str, bool]]:
    """Return the level of each finding in a CMake package in a folder of a repository, and whether nobody starts it."""
    files = {path.replace("__", "/").replace("_dot_", "."): text for path, text in files.items()}
    files = {f"src/my_pkg/{path}" if not path.startswith("/") else path[1:]: text for path, text in files.items()}
    base = {"package.xml": manifest("  <exec_depend>ros2launch</exec_depend>\n", "ament_cmake")}
    base |= {"CMakeLists.txt": CMAKE.format(""), "launch/a.launch.py": NODE}
    written = {**{f"src/my_pkg/{path}": text for path, text in base.items()}, **files}
    return [(each.severity.value, UNSTARTED in each.message) for each in lint_files(written, [code]).findings]


def test_a_launch_file_that_is_installed_is_started_by_its_name() -> None:
    assert found(CMakeLists_dot_txt=CMAKE.format(INSTALL)) == [("error", False)]


@pytest.mark.parametrize("cmake", [CMAKE.format(""), "# Copyright\n", CMAKE.format("").replace("ament_package()", "")])
def test_one_that_nothing_installs_is_started_by_nobody(cmake: str) -> None:
    assert found(CMakeLists_dot_txt=cmake) == [("info", True)]


@pytest.mark.parametrize(
    ("files", "is_started"),
    [
        ({"README_dot_md": "ros2 launch src/my_pkg/launch/a.launch.py\n"}, True),
        ({"/README_dot_md": "    ros2 launch ./src/my_pkg/launch/a.launch.py speed:=1\n"}, True),
        ({"/README_dot_md": "cd launch; ros2 launch -d a.launch.py\n"}, True),
        ({"README_dot_md": "ros2 launch my_pkg a.launch.py\n"}, False),
        ({"README_dot_md": "`launch/a.launch.py` starts all\n"}, False),
        ({"/README_dot_md": "src/my_pkg/launch/a.launch.py\n"}, False),
        ({"/tools__go_dot_sh": "ros2 launch src/my_pkg/launch/a.launch.py\n"}, True),
        ({"/tools__go_dot_sh": "# ros2 launch src/my_pkg/launch/a.launch.py\n"}, False),
        ({"/tools__go_dot_sh": "FILE=src/my_pkg/launch/a.launch.py\nros2 launch $FILE\n"}, True),
        ({"go_dot_sh": "ros2 launch $PKG \\\n  a.launch.py\n"}, False),
        ({"go_dot_sh": "FILE=a.launch.py\n"}, True),
        ({"/go_dot_sh": "FILE=a.launch.py\n"}, False),
        ({"/Dockerfile": 'CMD ["ros2", "launch", "/ws/src/my_pkg/launch/a.launch.py"]\n'}, True),
        ({"/Dockerfile": 'CMD ["ros2", "launch", "my_pkg", "a.launch.py"]\n'}, False),
        ({"test__test_a_dot_py": "import os\n\nFILE = os.path.join(os.path.dirname(__file__), 'a.launch.py')\n"}, True),
        ({"launch__b_dot_launch_dot_py": BY_SHARE}, False),
        ({"launch__b_dot_launch_dot_py": BY_PATH}, False),
        ({"launch__b_dot_launch_dot_py": BY_PATH, "README_dot_md": "ros2 launch launch/b.launch.py"}, True),
    ],
)
def test_who_gives_its_path_meets_its_faults(files: dict[str, str], is_started: bool) -> None:
    assert found(**files) == [("error", False) if is_started else ("info", True)]


def test_a_test_that_cmake_runs_by_its_path() -> None:
    cmake = CMAKE.format("find_package(launch_testing_ament_cmake REQUIRED)\nadd_launch_test(launch/a.launch.py)\n")
    assert found(CMakeLists_dot_txt=cmake) == [("error", False)]


def test_what_is_told_of_the_file_as_a_whole_is_met_by_nobody_either() -> None:
    text = NODE.replace("generate_launch_description", "generate")
    assert found("LCH001", launch__a_dot_launch_dot_py=text) == [("info", True)]

"""Folders that are not installed, and that only actions of launch files open which are off by default."""

from __future__ import annotations

import pytest

from rospkg_cli.example import BACKDROPS, SETUP_PY, existing_files
from rospkg_cli.testing import lint_files

PARAMETERS = "talker:\n  ros__parameters:\n    rate: 2.0\n"
PYTHON = """\
import os

from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch.conditions import IfCondition
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node


def generate_launch_description():
    config = os.path.join(get_package_share_directory('my_pkg'), 'config', 'a.yaml')
    return LaunchDescription([
        DeclareLaunchArgument('tune', default_value='false'),
        Node(
            package='demo_nodes_cpp',
            executable='talker',
            condition=IfCondition(LaunchConfiguration('tune')),
            parameters=[config],
        ),
    ])
"""
ARGUMENT = PYTHON.replace(
    "    return LaunchDescription([",
    "    return LaunchDescription([\n        DeclareLaunchArgument('params', default_value=config),",
).replace("[config]", "[LaunchConfiguration('params')]")
BOTH = PYTHON.replace(
    "    ])\n", "        Node(package='demo_nodes_cpp', executable='listener', parameters=[config]),\n    ])\n"
)
XML = """\
<launch>
  <arg name="tune" default="false"/>
  <node pkg="demo_nodes_cpp" exec="talker" if="$(var tune)">
    <param from="$(find-pkg-share my_pkg)/config/a.yaml"/>
  </node>
</launch>
"""
INCLUDE = """\
<launch>
  <include file="$(find-pkg-share my_pkg)/launch/a.launch.xml"><arg name="tune" value="{}"/></include>
</launch>
"""
YAML = """\
launch:
  - include:
      file: "$(find-pkg-share my_pkg)/launch/a.launch.xml"
      arg:
        - name: tune
          value: "true"
"""
NODE = "import os\nPATH = os.path.join(get_package_share_directory('my_pkg'), 'config', 'a.yaml')\n"

PACKAGE = "        ('share/' + package_name, ['package.xml']),\n"
LAUNCH_ALONE = f"from glob import glob\n{SETUP_PY}".replace(
    PACKAGE, f"{PACKAGE}        ('share/' + package_name + '/launch', glob('launch/*')),\n"
)


def level(kind: str, more: dict[str, str]) -> str:
    files = {**existing_files(BACKDROPS[kind]), "config/a.yaml": PARAMETERS, **more}
    if kind == "ament_cmake":
        rule = "install(DIRECTORY launch DESTINATION share/${PROJECT_NAME})\nament_package"
        files["CMakeLists.txt"] = files["CMakeLists.txt"].replace("ament_package", rule)
    else:
        files["setup.py"] = LAUNCH_ALONE
    found = lint_files(files, ["CMK101", "SET206"]).findings
    return next(each.severity.value for each in found if "`config/`" in each.message)


@pytest.mark.parametrize("kind", ["ament_cmake", "ament_python"])
@pytest.mark.parametrize(
    ("more", "expected"),
    [
        ({"launch/a.launch.py": PYTHON}, "info"),
        ({"launch/a.launch.py": PYTHON.replace("'false'", "'true'")}, "error"),
        ({"launch/a.launch.py": ARGUMENT}, "info"),
        ({"launch/a.launch.py": ARGUMENT.replace("'false'", "'true'")}, "error"),
        ({"launch/a.launch.py": BOTH}, "error"),
        ({"launch/a.launch.py": PYTHON, "scripts/a.py": NODE}, "error"),
        ({"launch/a.launch.py": PYTHON, "README.md": "`ros2 launch my_pkg a.launch.py tune:=true`\n"}, "error"),
        ({"launch/a.launch.py": PYTHON, "README.md": "`ros2 launch my_pkg a.launch.py tune:=false`\n"}, "info"),
        ({"launch/a.launch.xml": XML}, "info"),
        ({"launch/a.launch.xml": XML.replace("if=", "unless=")}, "error"),
        ({"launch/a.launch.xml": XML, "launch/b.launch.xml": INCLUDE.format("true")}, "error"),
        ({"launch/a.launch.xml": XML, "launch/b.launch.xml": INCLUDE.format("false")}, "info"),
        ({"launch/a.launch.xml": XML, "launch/b.launch.yaml": YAML}, "error"),
    ],
)
def test_who_opens_a_folder(kind: str, more: dict[str, str], expected: str) -> None:
    assert level(kind, more) == expected

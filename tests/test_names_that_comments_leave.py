"""Files and programs whose names people are to replace, by a comment beside or above them."""

from __future__ import annotations

import pytest

from rospkg_cli.example import BACKDROPS, CMAKE, existing_files
from rospkg_cli.testing import lint_files

INSTALLS = CMAKE.replace(
    "ament_package", "install(DIRECTORY launch maps meshes urdf DESTINATION share/${PROJECT_NAME})\nament_package"
)
PYTHON = """\
import os

from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node


def generate_launch_description():
    share = get_package_share_directory('my_pkg')
    return LaunchDescription([
        {}
        DeclareLaunchArgument(
            'map',
            default_value=os.path.join(share, 'maps', 'lab.yaml'),
        ),
        Node(
            package='nav2_map_server',
            executable='map_server',
            parameters=[{{'yaml_filename': LaunchConfiguration('map')}}],
        ),
    ])
"""
XML = """\
<launch>
  {}
  <arg name="map" default="$(find-pkg-share my_pkg)/maps/lab.yaml"/>
  <node pkg="nav2_map_server" exec="map_server"><param name="yaml_filename" value="$(var map)"/></node>
</launch>
"""
ROBOT = """\
<robot name="robot">
  <link name="base">
    <visual>
      {}
      <geometry>
        <mesh filename="package://my_pkg/meshes/base.stl"/>
      </geometry>
    </visual>
  </link>
</robot>
"""
SHOW = '<launch>\n  <let name="model" value="$(find-pkg-share my_pkg)/urdf/robot.urdf"/>\n</launch>\n'
MAP = "{}\nimage: office.pgm\nresolution: 0.05\norigin: [0.0, 0.0, 0.0]\n"
SERVE = """\
<launch>
  <let name="map" value="$(find-pkg-share my_pkg)/maps/office.yaml"/>
  <log message="$(var map)"/>
</launch>
"""
TELLS = ("Put your own {} here", "Change this to your {}", "TODO: set this to your {}", "You may use your own {}")
SILENT = ("The {} of the lab", "your robot is shown here", "Your {} is put here by the driver", "keep this {}")


def level(code: str, files: dict[str, str]) -> str:
    there = {**existing_files(BACKDROPS["ament_cmake"]), "CMakeLists.txt": INSTALLS}
    there |= {"meshes/wheel.stl": "solid wheel\n", "maps/hall.pgm": "P5\n", **files}
    return next(each.severity.value for each in lint_files(there, [code]).findings)


def said(words: str, what: str, markup: bool) -> str:
    text = words.format(what)
    return f"<!-- {text} -->" if markup else f"# {text}"


@pytest.mark.parametrize(("words", "loud"), [*((each, False) for each in TELLS), *((each, True) for each in SILENT)])
def test_what_a_comment_above_says(words: str, loud: bool) -> None:
    expected = "warning" if loud else "info"
    assert level("LCH003", {"launch/a.launch.py": PYTHON.format(said(words, "map", False))}) == expected
    assert level("LCH003", {"launch/a.launch.xml": XML.format(said(words, "map", True))}) == expected
    robot = {"urdf/robot.urdf": ROBOT.format(said(words, "mesh", True)), "launch/show.launch.xml": SHOW}
    assert level("URD002", robot) == expected
    parameters = {"maps/office.yaml": MAP.format(said(words, "picture", False)), "launch/a.launch.xml": SERVE}
    assert level("PRM010", parameters) == expected


@pytest.mark.parametrize(
    ("comment", "expected"),
    [
        ("<!-- TODO: export the mesh -->", "info"),
        ("<!-- TODO: measure the mass -->", "warning"),
        ("<!-- Put your mesh here -->\n      <origin xyz='0 0 0'/>", "warning"),
    ],
)
def test_a_task_above_a_mesh(comment: str, expected: str) -> None:
    assert level("URD002", {"urdf/robot.urdf": ROBOT.format(comment), "launch/show.launch.xml": SHOW}) == expected

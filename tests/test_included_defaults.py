"""An argument that only an included file declares has its default, by which a node may be off (DEP103)."""

from __future__ import annotations

import pytest

from rospkg_cli.example import BACKDROPS, existing_files, manifest
from rospkg_cli.testing import lint_files

PACKAGE = existing_files(BACKDROPS["ament_python"])
PYTHON = """\
from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, IncludeLaunchDescription, OpaqueFunction
from launch.conditions import IfCondition
from launch.launch_description_sources import (
    PythonLaunchDescriptionSource, get_launch_description_from_python_launch_file,
)
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node

"""
LOADED = "get_launch_description_from_python_launch_file(HERE + '/launch/common.launch.py')"
INCLUDED = "IncludeLaunchDescription(PythonLaunchDescriptionSource(HERE + '/launch/common.launch.py'))"
GIVING = INCLUDED[:-1] + ", launch_arguments={'gui': 'true'}.items())"
ELSEWHERE = "IncludeLaunchDescription(PythonLaunchDescriptionSource(LaunchConfiguration('other')))"
ON = "DeclareLaunchArgument('gui', default_value='true')"
OFF = "DeclareLaunchArgument('gui', default_value='false')"


def including(*actions: str) -> str:
    """Return a launch file with some actions before a node under a condition."""
    node = "Node(package='joy', executable='joy_node', condition=IfCondition(LaunchConfiguration('gui')))"
    listed = "".join(f"        {each},\n" for each in (*actions, node))
    here = "    HERE = get_package_share_directory('my_pkg')\n"
    return f"{PYTHON}\ndef generate_launch_description():\n{here}    return LaunchDescription([\n{listed}    ])\n"


def declaring(*actions: str) -> str:
    return f"{PYTHON}\ndef generate_launch_description():\n    return LaunchDescription([{', '.join(actions)}])\n"


def told(files: dict[str, str]) -> tuple[str, str]:
    lines = "  <exec_depend>ros2launch</exec_depend>\n"
    setup = PACKAGE["setup.py"].replace("data_files=[", "data_files=[('share/my_pkg/launch', glob('launch/*')),", 1)
    setup = f"from glob import glob\n{setup}"
    (only,) = lint_files({**PACKAGE, "package.xml": manifest(lines), "setup.py": setup, **files}, ["DEP103"]).findings
    return only.severity.value, only.message.partition("with `")[2].partition("`")[0]


@pytest.mark.parametrize("way", [LOADED, INCLUDED])
@pytest.mark.parametrize(("declared", "level"), [(OFF, "info"), (ON, "warning"), ("", "warning")])
def test_the_default_of_an_included_file(way: str, declared: str, level: str) -> None:
    found = told({"launch/robot.launch.py": including(way), "launch/common.launch.py": declaring(declared)})
    assert found == (level, "gui:=true" if level == "info" else "")


@pytest.mark.parametrize(
    "actions", [(GIVING,), (ON, LOADED), (INCLUDED, ELSEWHERE)], ids=["given", "declared", "another"]
)
def test_what_may_give_it_another_value(actions: tuple[str, ...]) -> None:
    files = {"launch/robot.launch.py": including(*actions), "launch/common.launch.py": declaring(OFF)}
    assert told(files) == ("warning", "")


def test_a_file_that_an_included_one_includes() -> None:
    inner = INCLUDED.replace("HERE", "get_package_share_directory('my_pkg')").replace("common", "inner")
    files = {"launch/robot.launch.py": including(INCLUDED), "launch/common.launch.py": declaring(inner)}
    assert told({**files, "launch/inner.launch.py": declaring(OFF)}) == ("info", "gui:=true")
    both = {**files, "launch/common.launch.py": declaring(ON, inner)}
    assert told({**both, "launch/inner.launch.py": declaring(OFF)}) == ("warning", "")


def test_a_launch_file_in_xml() -> None:
    text = """\
<launch>
  <include file="$(find-pkg-share my_pkg)/launch/common.launch.py"/>
  <node pkg="joy" exec="joy_node" if="$(var gui)"/>
</launch>
"""
    for declared, expected in ((OFF, ("info", "gui:=true")), (ON, ("warning", ""))):
        assert told({"launch/robot.launch.xml": text, "launch/common.launch.py": declaring(declared)}) == expected

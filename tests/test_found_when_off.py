"""The share of a package that only actions ask for which are off by default is an info where it is bound (DEP103)."""

from __future__ import annotations

import pytest

from rospkg_cli.example import BACKDROPS, existing_files, manifest
from rospkg_cli.testing import lint_files

TEXT = """\
import os

from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, IncludeLaunchDescription
from launch.conditions import IfCondition
from launch.launch_description_sources import PythonLaunchDescriptionSource
from launch.substitutions import LaunchConfiguration, PathJoinSubstitution, PythonExpression
from launch_ros.actions import Node
from launch_ros.substitutions import FindPackageShare


def generate_launch_description():
    nav, cam = LaunchConfiguration('nav'), LaunchConfiguration('cam')
    depth, on = LaunchConfiguration('depth'), LaunchConfiguration('on')
    share = {share}
    return LaunchDescription([
        DeclareLaunchArgument('nav', default_value='false'), DeclareLaunchArgument('cam', default_value='false'),
        DeclareLaunchArgument('depth', default_value='3d'), DeclareLaunchArgument('on', default_value='true'),
        {actions}
    ])
"""
FOUND = "FindPackageShare('joy')"
ASKED = "get_package_share_directory('joy')"
INCLUDE = (
    "IncludeLaunchDescription(PythonLaunchDescriptionSource(PathJoinSubstitution([share, 'launch', 'a.launch.py'])){})"
)
BY_NAV = INCLUDE.format(", condition=IfCondition(nav)")
BY_CAM = INCLUDE.format(
    ", condition=IfCondition(PythonExpression([\"'\", cam, \"' == 'true' and '\", depth, \"' == '3d'\"]))"
)
ALWAYS = INCLUDE.format("")
BY_ON = INCLUDE.format(", condition=IfCondition(on)")
PLACED = "DeclareLaunchArgument('map', default_value=PathJoinSubstitution([share, 'maps', 'a.yaml']))"


def told(share: str, *actions: str, text: str = TEXT) -> tuple[str, str]:
    package = existing_files(BACKDROPS["ament_python"])
    text = text.format(share=share, actions=",\n        ".join(actions))
    files = {
        **package,
        "package.xml": manifest("  <exec_depend>ros2launch</exec_depend>\n"),
        "launch/a.launch.py": text,
    }
    (only,) = (each for each in lint_files(files, ["DEP103"]).findings if "`joy`" in each.message)
    return only.severity.value, only.message.partition("with `")[2].partition("`")[0]


@pytest.mark.parametrize(
    ("actions", "argument"),
    [
        ((BY_NAV,), "nav:=true"),
        ((BY_CAM,), "cam:=true"),
        ((BY_CAM, BY_NAV), "cam:=true"),
        ((BY_NAV, BY_CAM), "nav:=true"),
    ],
)
def test_a_share_that_only_such_actions_ask_for(actions: tuple[str, ...], argument: str) -> None:
    assert told(FOUND, *actions) == ("info", argument)


@pytest.mark.parametrize("other", [ALWAYS, BY_ON, PLACED])
def test_a_share_that_another_action_asks_for(other: str) -> None:
    assert told(FOUND, BY_NAV, other) == ("warning", "")


def test_a_path_through_two_variables() -> None:
    share = f"{FOUND}\n    path = PathJoinSubstitution([share, 'launch', 'a.launch.py'])"
    action = BY_NAV.replace("PathJoinSubstitution([share, 'launch', 'a.launch.py'])", "path")
    assert told(share, action) == ("info", "nav:=true")


def test_what_python_itself_asks_for() -> None:
    assert told(ASKED, BY_NAV) == ("warning", "")


@pytest.mark.parametrize(("taken", "level"), [("true", "info"), ("false", "warning")])
def test_an_action_that_only_another_branch_adds(taken: str, level: str) -> None:
    body = (
        "    joy = Node(package='joy', executable='joy_node')\n"
        f"    if LaunchConfiguration('nav').perform(context) == '{taken}':\n        return [joy]\n    return []"
    )
    text = TEXT.replace("def generate", f"def nodes(context):\n{body}\n\n\ndef generate")
    text = text.replace("import Decl", "import OpaqueFunction, Decl")
    assert told("None", "OpaqueFunction(function=nodes)", text=text)[0] == level

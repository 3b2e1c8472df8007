"""Faults behind the place where a launch ends, as it looks for a package that nothing brings: infos."""

from __future__ import annotations

import pytest

from rospkg_cli.checks.launch.unmet_lookup import is_brought_by_nothing
from rospkg_cli.example import CMAKE, manifest
from rospkg_cli.package.workspace import Workspace
from rospkg_cli.testing import lint_files

IMPORTS = """\
import os

from ament_index_python.packages import PackageNotFoundError, get_package_share_directory
from launch import LaunchDescription
from launch.actions import (
    DeclareLaunchArgument, GroupAction, IncludeLaunchDescription, OpaqueFunction, RegisterEventHandler, TimerAction
)
from launch.conditions import IfCondition
from launch.launch_description_sources import PythonLaunchDescriptionSource
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node
from launch_ros.substitutions import FindPackageShare


"""
ROBOT = "Node(package='robot_state_publisher', executable='robot_state_publisher')"
PYTHON = IMPORTS + "def generate_launch_description():\n    {}\n    return LaunchDescription([{}])\n"
SHARE = "share = get_package_share_directory('{}')"
INCLUDE = (
    "IncludeLaunchDescription(PythonLaunchDescriptionSource([FindPackageShare('farm_description'), '/a.launch.py']){})"
)
CALLED = (
    "def setup(context):\n    share = get_package_share_directory('farm_description')\n    return [{}]\n\n\n"
    "def generate_launch_description():\n    return LaunchDescription([OpaqueFunction(function=setup), {}])\n"
)


def found(text: str, code: str, path: str = "launch/a.launch.py", **more: str) -> list[tuple[str, bool]]:
    """Return level and whether the lack of the package is told, of each finding in a launch file that is installed."""
    files = {
        "package.xml": manifest("", "ament_cmake"),
        "CMakeLists.txt": CMAKE.replace(
            "ament_package", "install(DIRECTORY launch DESTINATION share/${PROJECT_NAME})\nament_package"
        ),
        path: text,
        **more,
    }
    told = "but the launch ends before, as nothing here brings the package `farm_description`"
    return [(each.severity.value, told in each.message) for each in lint_files(files, [code]).findings]


LOUD, HIDDEN = [("warning", False)], [("info", True)]


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        (PYTHON.format(SHARE.format("farm_description"), ROBOT), HIDDEN),
        (PYTHON.format("share = FindPackageShare('x').find('farm_description')", ROBOT), HIDDEN),
        (PYTHON.format(SHARE.format("nav2_bringup"), ROBOT), LOUD),
        (PYTHON.format(SHARE.format("my_pkg"), ROBOT), LOUD),
        (PYTHON.format("share = FindPackageShare('farm_description')", ROBOT), LOUD),
        (PYTHON.format("if os.environ['X']:\n        " + SHARE.format("farm_description"), ROBOT), LOUD),
        (
            PYTHON.format(
                "try:\n        "
                + SHARE.format("farm_description")
                + "\n    except PackageNotFoundError:\n        share = ''",
                ROBOT,
            ),
            LOUD,
        ),
        (PYTHON.format("pass", f"{INCLUDE.format('')}, {ROBOT}"), HIDDEN),
        (PYTHON.format("pass", f"GroupAction([{INCLUDE.format('')}]), {ROBOT}"), HIDDEN),
        (PYTHON.format("pass", f"{ROBOT}, {INCLUDE.format('')}"), LOUD),
        (
            PYTHON.format("pass", INCLUDE.format(", condition=IfCondition(LaunchConfiguration('x'))") + f", {ROBOT}"),
            LOUD,
        ),
        (PYTHON.format("pass", f"TimerAction(period=5.0, actions=[{INCLUDE.format('')}]), {ROBOT}"), LOUD),
        (PYTHON.format("pass", f"Node(package='farm_description', executable='a'), {ROBOT}"), LOUD),
        (IMPORTS + CALLED.format(ROBOT, ""), HIDDEN),
        (IMPORTS + CALLED.format("", ROBOT), LOUD),
        (f"{IMPORTS}def unused():\n    {SHARE.format('farm_description')}\n\n\n" + PYTHON.format("pass", ROBOT), LOUD),
    ],
)
def test_what_a_python_launch_file_comes_to(text: str, expected: list[tuple[str, bool]]) -> None:
    assert found(text, "PRM008") == expected


XML = '<launch>\n{}\n  <node pkg="robot_state_publisher" exec="robot_state_publisher"{}\n{}\n</launch>\n'
LOOK = '  <include file="$(find-pkg-share farm_description)/a.launch.xml"{}/>'


@pytest.mark.parametrize(
    ("before", "inside", "behind", "expected"),
    [
        (LOOK.format(""), "/>", "", HIDDEN),
        ("", "/>", LOOK.format(""), LOUD),
        (LOOK.format(' if="$(var x)"'), "/>", "", LOUD),
        ("", '><param name="x" value="$(find-pkg-share farm_description)"/></node>', "", HIDDEN),
        ('  <arg name="x" default="$(find-pkg-share farm_description)"/>', "/>", "", HIDDEN),
        (f'  <timer period="5.0">{LOOK.format("")}</timer>', "/>", "", LOUD),
        (LOOK.format("").replace("farm_description", "nav2_bringup"), "/>", "", LOUD),
    ],
)
def test_what_an_xml_launch_file_comes_to(
    before: str, inside: str, behind: str, expected: list[tuple[str, bool]]
) -> None:
    assert found(XML.format(before, inside, behind), "PRM008", "launch/a.launch.xml") == expected


def test_a_package_of_a_repository_that_is_listed_may_come() -> None:
    assert is_brought_by_nothing("farm_description", Workspace())
    assert not is_brought_by_nothing("farm_description", Workspace(is_complete=False))
    listed = Workspace(is_complete=False, missing_repositories=frozenset({"farm"}))
    assert not is_brought_by_nothing("farm_description", listed)
    assert is_brought_by_nothing("crane_description", listed)
    assert not is_brought_by_nothing("farm_description", Workspace(prefix_names=frozenset({"farm_description"})))
    assert not is_brought_by_nothing("nav2_bringup", Workspace())


@pytest.mark.parametrize(
    ("code", "action"),
    [
        ("LCH002", "Node(package='my_pkg', executable='missing')"),
        ("LCH008", "Node(package='rviz2', executable='rviz2', name=LaunchConfiguration('nam'))"),
        ("LCH005", "Node(package='rviz2', executable='rviz2', type='x')"),
        ("LCH014", "Node(package='rviz2', executable='rviz2', names='x')"),
    ],
)
def test_other_rules_of_launch_files_ask_as_well(code: str, action: str) -> None:
    declared = "DeclareLaunchArgument('name', default_value='a'), "
    plain = found(PYTHON.format(SHARE.format("my_pkg"), declared + action), code)
    assert [level for level, _ in plain] in (["error"], ["warning"])
    assert found(PYTHON.format(SHARE.format("farm_description"), declared + action), code) == HIDDEN


def test_what_python_stops_at_before_the_look_up_stays_loud() -> None:
    text = PYTHON.format(
        f"node = Node(package='rviz2', executable='rviz2', names='x')\n    {SHARE.format('farm_description')}", "node"
    )
    assert found(text, "LCH014") == [("error", False)]


def test_the_package_itself_is_told_as_before() -> None:
    assert ("warning", False) in found(PYTHON.format(SHARE.format("farm_description"), ROBOT), "DEP103")

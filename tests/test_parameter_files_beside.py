"""LCH003: a missing file of a node that gets others too, or that the node never asks for, is an info."""

from __future__ import annotations

import pytest

from rospkg_cli.example import SETUP_PY_FOR_ALL, manifest, scripts, setup_py
from rospkg_cli.testing import lint_files

LAUNCH = """\
from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch.actions import IncludeLaunchDescription
from launch.launch_description_sources import AnyLaunchDescriptionSource
from launch_ros.actions import Node


def generate_launch_description():
    share = get_package_share_directory('my_pkg')
    lost = share + '/config/arm.yaml'
    there = share + '/config/robot.yaml'
    return LaunchDescription([{}])
"""
NODE = "Node(package='my_pkg', executable='talker', parameters=[{}])"
CODE = "from rclpy.node import Node\n\n\ndef main():\n    node = Node('talker')\n    node.declare_parameter('{}', '')\n"
FILES = {
    "package.xml": manifest("  <exec_depend>launch_ros</exec_depend>\n  <exec_depend>rclpy</exec_depend>\n"),
    "setup.py": setup_py(scripts("talker = my_pkg.talker:main")),
    "config/robot.yaml": "/**:\n  ros__parameters:\n    rate: 2.0\n",
}


def found(code: str, *given: str) -> list[tuple[str, str]]:
    nodes = ", ".join(NODE.format(each) for each in given)
    files = {**FILES, "my_pkg/talker.py": CODE.format(code), "launch/a.launch.py": LAUNCH.format(nodes)}
    return [(each.severity.value, each.message) for each in lint_files(files, ["LCH003"]).findings]


def in_launch(*nodes: str) -> list[tuple[str, str]]:
    files = {**FILES, "my_pkg/talker.py": CODE.format("rate"), "launch/a.launch.py": LAUNCH.format(", ".join(nodes))}
    return [(each.severity.value, each.message) for each in lint_files(files, ["LCH003"]).findings]


@pytest.mark.parametrize(
    ("given", "level"),
    [
        (("lost",), "warning"),
        (("lost, there",), "info"),
        (("lost, {'rate': 2.0}",), "info"),
        (("lost", "lost, there"), "warning"),
        (("lost, there", "there, lost"), "info"),
    ],
)
def test_a_parameter_file_beside_others(given: tuple[str, ...], level: str) -> None:
    ((told, message),) = found("rate", *given)
    assert told == level
    assert ("without what it sets" in message) == (level == "info")


@pytest.mark.parametrize(
    ("code", "level"), [("calibration", "warning"), ("rate", "info"), ("other.calibration", "info")]
)
def test_a_file_that_a_node_never_asks_for(code: str, level: str) -> None:
    ((told, message),) = found(code, "{'calibration': lost}")
    assert told == level
    assert ("no code of `my_pkg` declares `calibration`" in message) == (level == "info")


def test_a_file_that_another_node_asks_for() -> None:
    ((told, _),) = found("rate", "{'calibration': lost}", "lost")
    assert told == "warning"


@pytest.mark.parametrize(
    ("package", "given", "why"),
    [
        ("unheard_of", "{'calibration': lost}", "nothing is shown to open what `calibration` is"),
        ("unheard_of", "{'camera': {'content': lost}}", "nothing is shown to open what `camera.content` is"),
        ("unheard_of", "{'calibration_file': lost}", ""),
        ("unheard_of", "{'camera_info_url': lost}", ""),
        ("unheard_of", "{'camera': {'path': lost}}", ""),
        ("unheard_of", "lost", ""),
        ("moveit_ros_move_group", "{'start_state': {'content': lost}}", "nothing is shown to open"),
        ("nav2_map_server", "{'yaml_filename': lost}", ""),
        ("nav2_map_server", "{'yaml_file': lost}", "`nav2_map_server` has no parameter `yaml_file`"),
    ],
)
def test_a_file_that_is_the_value_of_a_parameter(package: str, given: str, why: str) -> None:
    node = f"Node(package='{package}', executable='main', parameters=[{given}])"
    ((told, message),) = in_launch(node)
    assert told == ("info" if why else "warning")
    assert why in message


def test_a_file_that_the_launch_opens_as_well() -> None:
    node = "Node(package='unheard_of', executable='main', parameters=[{'calibration': lost}])"
    ((told, message),) = in_launch(node, "IncludeLaunchDescription(AnyLaunchDescriptionSource(lost))")
    assert told != "info"
    assert "the launch stops there" in message


@pytest.mark.parametrize(("name", "level"), [("calibration", "info"), ("calibration_file", "warning")])
def test_a_path_on_one_machine(name: str, level: str) -> None:
    node = f"Node(package='unheard_of', executable='main', parameters=[{{'{name}': '/home/ada/my_pkg/robot.yaml'}}])"
    files = {**FILES, "setup.py": SETUP_PY_FOR_ALL, "robot.yaml": "", "launch/a.launch.py": LAUNCH.format(node)}
    (found,) = lint_files(files, ["DEP118"]).findings
    assert found.severity.value == level
    assert ("is shown to read it by this key" in found.message) == (level == "info")

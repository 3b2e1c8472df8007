"""LCH003: a missing file of a node that gets others too, or that the node never asks for, is an info."""

from __future__ import annotations

import pytest

from rospkg_cli.example import manifest, scripts, setup_py
from rospkg_cli.testing import lint_files

LAUNCH = """\
from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
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

"""Parameter files that PyYAML reads before rcl does: those of components, and what RewrittenYaml writes anew."""

from __future__ import annotations

import pytest

from rospkg_cli.example import CMAKE, manifest
from rospkg_cli.finding import Finding
from rospkg_cli.testing import lint_files

LAUNCH = """\
import os

from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch_ros.actions import ComposableNodeContainer, Node
from launch_ros.descriptions import ComposableNode
from nav2_common.launch import RewrittenYaml


def generate_launch_description():
    config = os.path.join(get_package_share_directory('my_pkg'), 'config', 'robot.yaml')
    return LaunchDescription([{}])
"""
NODE = "Node(package='turtlesim', executable='turtlesim_node', name='sim', parameters=[{}])"
COMPONENT = (
    "ComposableNodeContainer(package='rclcpp_components', executable='component_container', name='all', namespace='', "
    "composable_node_descriptions=[ComposableNode(package='a', plugin='a::B', name='sim', parameters=[config])])"
)
REWRITTEN = NODE.format("RewrittenYaml(source_file=config, param_rewrites={}, convert_types=True)")
VALUES = "sim:\n  ros__parameters:\n    {}\n"


def levels(started: str, values: str) -> list[str]:
    return [each.severity.value for each in found(started, values)]


def messages(started: str, values: str) -> list[str]:
    return [each.message for each in found(started, values)]


def found(started: str, values: str) -> list[Finding]:
    files = {
        "package.xml": manifest("  <exec_depend>turtlesim</exec_depend>\n", "ament_cmake"),
        "CMakeLists.txt": CMAKE.replace(
            "ament_package", "install(DIRECTORY launch config DESTINATION share/${PROJECT_NAME})\nament_package"
        ),
        "launch/a.launch.py": LAUNCH.format(started),
        "config/robot.yaml": VALUES.format(values),
    }
    return list(lint_files(files, ["PRM004"]).findings)


@pytest.mark.parametrize(
    ("started", "expected"),
    [
        (NODE.format("config"), ["error"]),
        (COMPONENT, ["info"]),
        (f"{NODE.format('config')}, {COMPONENT}", ["error"]),
    ],
)
def test_components_get_what_pyyaml_reads(started: str, expected: list[str]) -> None:
    assert levels(started, "a: &size 1\n    b: *size") == expected


def test_an_empty_list_has_no_type_for_a_component() -> None:
    assert levels(COMPONENT, "a: []") == ["warning"]


@pytest.mark.parametrize(
    ("values", "expected"),
    [
        ("a: &size 1\n    b: *size", []),
        ("a: &size 'x y'\n    b: *size", []),
        ("a: &size [1, 2]\n    b: *size", ["warning"]),
        ("a: &size {x: 1}\n    b: *size", ["warning"]),
        ("a: &size\n      x: 1\n    b: *size", ["warning"]),
        ("b: [1, 2.5]", ["warning"]),
    ],
)
def test_what_is_written_anew_has_no_aliases_of_single_values(values: str, expected: list[str]) -> None:
    assert levels(REWRITTEN, values) == expected


TYPED = "- name: a\n        type: b"
INNER = "- name: a\n        points: [1.0, 2.0]\n        size: 3\n      - name: b"


@pytest.mark.parametrize(
    ("items", "expected"),
    [
        (TYPED, ["warning"]),
        (f"{TYPED}\n        size: '3'\n        inner:\n          a: c", ["warning"]),
        ("- a: 1\n      - b: 2", ["warning"]),
        (INNER, ["warning"]),
        ("- a: 1", []),
        (f"{TYPED}\n        size: 3", ["error"]),
        ("- size: 3\n        name: a", ["error"]),
        ("- a: 1\n      - b: 2.5", ["error"]),
        (f"{TYPED}\n        size:", ["error"]),
        (f"{TYPED}\n      - {{}}", ["error"]),
        (f"{TYPED}\n      - [a]", ["warning"]),
        ("- [a]\n      - name: b", ["error"]),
    ],
)
def test_mappings_in_a_list_that_rcl_reads_past(items: str, expected: list[str]) -> None:
    assert levels(NODE.format("config"), f"b:\n      {items}") == expected


def test_what_becomes_of_such_a_list_is_told() -> None:
    assert "the node finds no `b`" in messages(NODE.format("config"), f"b:\n      {TYPED}")[0]

"""Arguments that well-known programs refuse when they start (LCH022)."""

from __future__ import annotations

import pytest

from rospkg_cli.example import manifest
from rospkg_cli.testing import lint_files

LAUNCH = """\
from launch import LaunchDescription
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node

x = LaunchConfiguration('x')


def made(words):
    return Node(package='tf2_ros', executable='static_transform_publisher', arguments=words)


def generate_launch_description():
    return LaunchDescription([{}])
"""
NODE = "Node(package='{}', executable='{}', arguments={})"
TRANSFORMS = ("tf2_ros", "static_transform_publisher")
SPAWNER = ("controller_manager", "spawner")
ENTITY = ("gazebo_ros", "spawn_entity.py")
NUMBERS = "'0', '0', '0', '0', '0', '0'"


def told(action: str, path: str = "launch/a.launch.py", **others: str) -> list[str]:
    text = LAUNCH.format(action) if path.endswith(".py") else f"<launch>\n{action}\n</launch>\n"
    files = {"package.xml": manifest("", "ament_cmake"), path: text}
    return [each.message for each in lint_files({**files, **others}, ["LCH022"]).findings]


@pytest.mark.parametrize(
    ("words", "part"),
    [
        (f"[{NUMBERS}, 'map', 'odom', '100']", "a number where `map` stands; there is no period as in ROS 1"),
        (f"[{NUMBERS}, '1', 'map', 'odom', '100']", "8 or 9 words, not 10; there is no period as in ROS 1"),
        (f"['0 0 0 0 0 0 map odom', {NUMBERS}]", "8 or 9 words, not 7"),
        ("'0 0 0 0 0 0 map'.split()", "not 7"),
        ("['--x', '0', '--frame_id', 'a', '--child-frame-id', 'b']", "has no option `--frame_id`, but `--frame-id`"),
        ("['--x', 'pi', '--frame-id', 'a', '--child-frame-id', 'b']", "reads a number for `--x`, not `pi`"),
        ("['--x', '0', '--frame-id', 'a']", "is not given `--child-frame-id`"),
        ("['--frame-id', 'a', '--child-frame-id']", "is given no value for `--child-frame-id`"),
        ("['--yaw', '1', '--qw', '1', '--frame-id', 'a', '--child-frame-id', 'b']", "angles or a quaternion, not both"),
        (f"['--x', '1', {NUMBERS}, 'a', 'b']", "with options or without, not both"),
        ("[]", "is not given `--frame-id` and `--child-frame-id`"),
    ],
)
def test_words_that_the_transform_publisher_refuses(words: str, part: str) -> None:
    (message,) = told(NODE.format(*TRANSFORMS, words))
    assert part in message


@pytest.mark.parametrize(
    "words",
    [
        f"[{NUMBERS}, 'map', 'odom']",
        f"[{NUMBERS}, '1', 'map', 'odom']",
        f"[x, {NUMBERS}, 'map', x]",
        f"[{NUMBERS}, x]",
        "[x]",
        "x",
        "['1.5m', '-.5', '+1', 'nan', 'INF', '1e-3', 'map', 'odom']",
        "['--x', '-1', '--frame-id', x, '--child-frame-id', 'b', '--ros-args', '-r', '__node:=tf']",
        "['--x', '0', x, 'a', '--frame-id', 'b']",
        "['--help']",
        f"[{NUMBERS}, 'map', 'odom', *x]",
    ],
)
def test_words_that_may_be_right(words: str) -> None:
    assert told(NODE.format(*TRANSFORMS, words)) == []


def test_a_function_that_makes_nodes_is_asked_for_each_of_them() -> None:
    assert len(told(f"made([{NUMBERS}, 'a', 'b']), made([{NUMBERS}, 'a', 'b', '10']), made(x)")) == 1


@pytest.mark.parametrize(
    ("words", "part"),
    [
        ("['a', '--controller_manager', '/controller_manager']", "has no option `--controller_manager`"),
        ("['-c', '/controller_manager']", "needs the name of a controller"),
        ("['a', '--start']", "has no option `--start`"),
    ],
)
def test_options_that_the_spawner_has_not(words: str, part: str) -> None:
    (message,) = told(NODE.format(*SPAWNER, words))
    assert part in message


@pytest.mark.parametrize(
    "words",
    [
        "['a', 'b', '--controller-manager', '/c', '--stopped', '-t', 'x/Y', '--switch-timeout', '-1']",
        "['a', '--controller-manager-tim', '10', '-c/a', '--param-file=x.yaml']",
        "['a', '--controller-ros-args', '-r a:=b', '--anything']",
        "[x, '--start']",
        "['-c', '/c', '--inactive', x]",
    ],
)
def test_options_that_the_spawner_may_have(words: str) -> None:
    assert told(NODE.format(*SPAWNER, words)) == []


def test_the_spawner_of_gazebo() -> None:
    assert "has no option `-name`" in told(NODE.format(*ENTITY, "['-topic', 't', '-name', 'a']"))[0]
    assert "needs `-entity`" in told(NODE.format(*ENTITY, "['-topic', 't']"))[0]
    assert told(NODE.format(*ENTITY, "['-topic', 't', '-entity', 'a', '-x', '-1.5', '-J', 'a', '1', '-q']")) == []


def test_args_of_xml_are_split_before_they_are_replaced() -> None:
    node = '<node pkg="tf2_ros" exec="static_transform_publisher" args="{}"/>'
    xml = "launch/a.launch.xml"
    assert "there is no period" in told(node.format("0 0 0 $(var y) 0 0 map odom 100"), xml)[0]
    for right in (
        "0 0 0 $(var y) 0 0 $(var p)map odom",
        "$(var y)",
        "'0 0' 0 0 map",
        "--frame-id a --child-frame-id b",
    ):
        assert told(node.format(right), xml) == []


def test_a_program_of_the_workspace_may_take_anything() -> None:
    action = NODE.format(*TRANSFORMS, f"[{NUMBERS}, 'map', 'odom', '100']")
    files = {"a/package.xml": manifest("", "ament_cmake", "a"), "a/launch/a.launch.py": LAUNCH.format(action)}
    own = {"b/package.xml": manifest("", "ament_cmake", "tf2_ros")}
    assert len(lint_files(files, ["LCH022"]).findings) == 1
    assert not lint_files({**files, **own}, ["LCH022"]).findings

"""Actions that event handlers wait for, and that nothing adds (LCH018)."""

from __future__ import annotations

import pytest

from rospkg_cli.example import manifest
from rospkg_cli.testing import lint_files

LAUNCH = """\
from launch import LaunchDescription
from launch.actions import ExecuteProcess, LogInfo, RegisterEventHandler
from launch.event_handlers import OnProcessExit, OnProcessStart
from launch_ros.actions import LifecycleNode
from launch_ros.event_handlers import OnStateTransition


def generate_launch_description():
    first = ExecuteProcess(cmd=['true'])
    second = ExecuteProcess(cmd=['true'])
    {}
    return LaunchDescription([{}])
"""
WAITS = "RegisterEventHandler(OnProcessExit(target_action=first, on_exit=[second]))"


def told(actions: str, before: str = "pass") -> list[tuple[str, str]]:
    files = {"package.xml": manifest("", "ament_cmake"), "launch/a.launch.py": LAUNCH.format(before, actions)}
    found = lint_files(files, ["LCH018"]).findings
    return [(each.severity.value, each.message.split("`")[1]) for each in found]


def test_what_is_waited_for_is_never_added() -> None:
    assert told(WAITS) == [("warning", "first")]
    both = f"{WAITS}, {WAITS.replace('Exit', 'Start').replace('on_exit', 'on_start')}"
    assert told(both) == [("warning", "first")]
    node = "state = LifecycleNode(package='a', executable='b', name='c', namespace='')"
    handler = "RegisterEventHandler(OnStateTransition(target_lifecycle_node=state, entities=[first, second]))"
    assert told(handler, node) == [("warning", "state")]


@pytest.mark.parametrize(
    ("actions", "before"),
    [
        (f"first, {WAITS}", "pass"),
        (WAITS, "all = [first]"),
        (f"*locals().values(), {WAITS}", "pass"),
        ("RegisterEventHandler(OnProcessExit(target_action=third, on_exit=[first, second]))", "third = made()"),
        ("RegisterEventHandler(OnProcessExit(on_exit=[first, second]))", "pass"),
    ],
)
def test_what_is_added_or_may_be(actions: str, before: str) -> None:
    assert told(actions, before) == []


def test_what_the_handler_holds_is_added_by_itself() -> None:
    assert told(f"second, {WAITS}") == [("info", "first")]
    assert told(f"second, {WAITS.replace('[second]', 'second')}") == [("info", "first")]
    assert told(f"second, {WAITS.replace('[second]', '[second, LogInfo(msg=str())]')}") == [("warning", "first")]
    again = WAITS.replace("first", "third").replace("Exit", "Start").replace("on_exit", "on_start")
    both = f"{WAITS}, {again}"
    assert told(both, "third = ExecuteProcess(cmd=['true'])") == [("warning", "first"), ("warning", "third")]


def test_copies_of_a_launch_file_are_one_finding() -> None:
    text = LAUNCH.format("pass", WAITS)
    files = {f"launch/{name}.launch.py": text for name in "bac"}
    other = text.replace("first = ExecuteProcess(cmd=['true'])", "first = ExecuteProcess(cmd=['false'])")
    files = {"package.xml": manifest("", "ament_cmake"), **files, "launch/d.launch.py": other}
    found = lint_files(files, ["LCH018"]).findings
    assert [(each.location.path, [place.path for place, _ in each.related]) for each in found] == [
        ("launch/a.launch.py", ["launch/b.launch.py", "launch/c.launch.py"]),
        ("launch/d.launch.py", []),
    ]


def test_a_comment_or_a_handler_that_is_not_added_makes_it_an_info() -> None:
    assert told(WAITS, "# first is started by hand") == [("info", "first")]
    assert "warning" not in [level for level, _ in told("second", f"handler = {WAITS}")]

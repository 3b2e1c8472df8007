"""What a Python launch file makes and never puts into its launch description is never started."""

from __future__ import annotations

import pytest

from rospkg_cli.example import manifest
from rospkg_cli.languages.python.file import parse_python
from rospkg_cli.package.launch.never_launched import never_launched
from rospkg_cli.source import Source
from rospkg_cli.testing import lint_files

TEXT = """\
import launch_ros
from launch import LaunchDescription
from launch.actions import ExecuteProcess, OpaqueFunction, RegisterEventHandler, TimerAction
from launch.event_handlers import OnProcessExit
from launch_ros.actions import Node

{module}


def generate_launch_description():
    {body}
    return LaunchDescription([{added}])
"""
NODE = "Node(package='joy', executable='joy_node')"
FIRST = "first = ExecuteProcess(cmd=['true'])"
WAITS = f"RegisterEventHandler(OnProcessExit(target_action=first, on_exit=[{NODE}]))"


def level(
    body: str = "pass", added: str = "", module: str = "", path: str = "launch/a.launch.py", code: str = "DEP103"
) -> str | None:
    text = TEXT.format(body=body, added=added, module=module)
    setup = "from setuptools import setup\n\nsetup(name='my_pkg', version='0.1.0', packages=['my_pkg'])\n"
    files = {
        "package.xml": manifest("  <exec_depend>ros2launch</exec_depend>\n"),
        "setup.py": setup,
        "my_pkg/__init__.py": "",
        path: text,
        "start.sh": f"ros2 launch {path}\n",
    }
    found = [each for each in lint_files(files, [code]).findings if code != "DEP103" or "joy" in each.message]
    return found[0].severity.value if found else None


@pytest.mark.parametrize(
    "body",
    [
        NODE,
        f"{NODE},",
        f"launch_ros.actions.{NODE},",
        f"[{NODE}, {NODE}]",
        f"TimerAction(period=1.0, actions=[{NODE}])",
        f"node = {NODE}\n    TimerAction(period=1.0, actions=[node])",
        f"node = {NODE}\n    TimerAction(period=1.0, actions=[node]),",
        f"node = {NODE}\n    later = TimerAction(period=1.0, actions=[node])",
        f"node = {NODE}\n    print(node)\n    nodes = [node]",
    ],
)
def test_a_statement_of_its_own_starts_nothing(body: str) -> None:
    assert level(body) is None


@pytest.mark.parametrize(
    "body",
    [
        f"started({NODE})",
        f"started({NODE}),",
        f"ld = LaunchDescription()\n    ld.add_action({NODE})\n    return ld",
        f"ld = LaunchDescription()\n    ld.add_entity({NODE}),\n    return ld",
        f"nodes = []\n    nodes += [{NODE}]\n    return LaunchDescription(nodes)",
        f"nodes = []\n    nodes.append({NODE}),\n    return LaunchDescription(nodes)",
        f"return LaunchDescription([each for each in [{NODE}]])",
        f"return LaunchDescription([TimerAction(period=1.0, actions=[{NODE}])])",
        f"{FIRST}\n    return LaunchDescription([first, {WAITS}])",
        f"first = started()\n    return LaunchDescription([{WAITS}])",
        f"yield {NODE}",
    ],
)
def test_what_may_be_added_counts_as_started(body: str) -> None:
    assert level(body) == "warning"


@pytest.mark.parametrize(
    "module",
    ["class Node:\n    def __init__(self, **given):\n        started(self)\n", "from starters.launch import Node"],
)
def test_a_class_that_is_only_called_like_an_action(module: str) -> None:
    text = TEXT.format(body=f"{NODE}", added="", module=module)
    file = parse_python(Source("launch/a.launch.py", text))
    assert [each for each in never_launched(file) if "joy" in text[each.start : each.end]] == []


@pytest.mark.parametrize(
    ("added", "body", "path", "expected"),
    [
        ("# joy,\n", "pass", "launch/a.launch.py", None),
        ("", "pass", "launch/a_launch.py", None),
        ("joy", "pass", "launch/a.launch.py", "warning"),
        ("", "started(joy)", "launch/a.launch.py", "warning"),
        ("", "started(globals())", "launch/a.launch.py", "warning"),
        ("", "pass\n\n\nnodes = [joy]", "launch/a.launch.py", None),
    ],
)
def test_what_a_module_binds_and_nothing_reads(added: str, body: str, path: str, expected: str | None) -> None:
    assert level(body, added, f"joy = {NODE}", path) == expected


def test_a_module_that_says_what_others_may_take() -> None:
    assert level(module=f"__all__ = ['joy']\njoy = {NODE}") == "warning"


def test_what_waits_for_an_action_that_nothing_starts() -> None:
    assert level(FIRST, WAITS) is None
    assert level(f"{FIRST}\n    started(first)", WAITS) == "warning"
    assert level("pass", WAITS, FIRST) is None
    assert level(f"{FIRST}\n    for first in started():\n        pass", WAITS) == "warning"


def test_an_action_that_is_a_statement_or_of_the_module_is_told() -> None:
    assert level(f"launch_ros.actions.{NODE},", code="LCH018") == "info"
    assert level(module=f"joy = {NODE}", code="LCH018") == "info"
    assert level(module=f"joy = {NODE}", added="# joy\n", code="LCH018") is None

"""IDL010: an annotation alone shows little of what a function is called with, and a finding is where it is worst."""

from __future__ import annotations

import pytest

from rospkg_cli.example import INTERFACES_BODY, INTERFACES_CMAKE, manifest, scripts, setup_py
from rospkg_cli.testing import lint_files

NODE = """\
import functools
import threading

import rclpy
from my_ifs.action import Drive
from my_ifs.msg import Status
from rclpy.node import Node
from my_pkg import tools


class Server(Node):
    def __init__(self):
        super().__init__('server')
        {start}

    def run(self, given: Status):
        {run}


def main():
    rclpy.init()
    rclpy.spin(Server())
"""
HEARS = "self.create_subscription(Status, 'status', self.run, 10)"
WRONG = "print(given.lost)"


def told(start: str, run: str = WRONG, tools: str = "") -> list[tuple[str, str]]:
    files = {
        "a/package.xml": manifest("  <depend>my_ifs</depend>\n  <depend>rclpy</depend>\n"),
        "a/setup.py": setup_py(scripts("server = my_pkg.server:main")),
        "a/my_pkg/__init__.py": "",
        "a/my_pkg/tools.py": tools,
        "a/my_pkg/server.py": NODE.format(start=start, run=run),
        "b/package.xml": manifest(INTERFACES_BODY, "ament_cmake").replace("my_pkg", "my_ifs"),
        "b/CMakeLists.txt": INTERFACES_CMAKE.replace("my_pkg", "my_ifs"),
        "b/msg/Status.msg": "float32 battery\n",
        "b/srv/SetMode.srv": "string mode\n---\nbool success\n",
        "b/action/Drive.action": "float32 goal_x\n---\nbool done\n---\nfloat32 left\n",
    }
    findings = lint_files(files, ["IDL010"]).findings
    return [(each.excerpt.strip(), each.severity.value) for each in findings]


@pytest.mark.parametrize(
    ("start", "expected"),
    [
        (HEARS, "error"),
        (HEARS.replace("self.run", "functools.partial(self.run)"), "info"),
        ("threading.Thread(target=self.run, args=(1,)).start()", "info"),
    ],
)
def test_who_calls_the_function(start: str, expected: str) -> None:
    assert told(start) == [(WRONG, expected)]


TOOL = "from my_ifs.msg import Status\n\n\ndef far(status: Status):\n    print(status.lost)\n"
SEVERAL = f"{TOOL}\n\ndef near(status: Status):\n    print(status.lost)\n"


@pytest.mark.parametrize("tools", [TOOL, SEVERAL])
def test_a_function_that_another_file_calls(tools: str) -> None:
    assert told("tools.far(self)", "pass", tools) == [("print(status.lost)", "info")]


def test_the_place_that_a_program_comes_to_is_told() -> None:
    assert told(f"{HEARS}\n\n    def idle(self, other: Status):\n        print(1, other.lost)") == [(WRONG, "error")]


@pytest.mark.parametrize("run", ["raise ValueError(given.lost)", "assert given.battery, given.lost"])
def test_what_is_said_of_a_failure(run: str) -> None:
    assert told(HEARS, run) == [(run, "info")]


@pytest.mark.parametrize(
    ("value", "expected"),
    [
        ("self.client.send_goal_async(Drive.Goal()).result()", []),
        ("Drive.Goal()", [("print(goal.accepted)", "error")]),
    ],
)
def test_the_handle_of_a_goal_that_is_called_so(value: str, expected: list[tuple[str, str]]) -> None:
    assert told(f"goal: Drive.Goal = {value}\n        print(goal.accepted)", "pass") == expected

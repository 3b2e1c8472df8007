"""IDL010: what rclpy hands to a callback goes before its annotation."""

from __future__ import annotations

import pytest

from rospkg_cli.example import INTERFACES_BODY, INTERFACES_CMAKE, manifest, scripts, setup_py
from rospkg_cli.testing import lint_files

NODE = """\
import functools

import rclpy
from my_ifs.action import Drive
from rclpy.action import ActionServer
from rclpy.node import Node


class Server(Node):
    def __init__(self):
        super().__init__('server')
        {}

    def run(self, given: {}):
        print(given.{})


def main():
    rclpy.init()
    rclpy.spin(Server())
"""
ACTION = "ActionServer(self, Drive, 'drive', {})"


def told(start: str, annotation: str = "Drive.Goal", field: str = "request") -> list[str]:
    files = {
        "a/package.xml": manifest("  <depend>my_ifs</depend>\n  <depend>rclpy</depend>\n"),
        "a/setup.py": setup_py(scripts("server = my_pkg.server:main")),
        "a/my_pkg/__init__.py": "",
        "a/my_pkg/server.py": NODE.format(start, annotation, field),
        "b/package.xml": manifest(INTERFACES_BODY, "ament_cmake").replace("my_pkg", "my_ifs"),
        "b/CMakeLists.txt": INTERFACES_CMAKE.replace("my_pkg", "my_ifs"),
        "b/msg/Status.msg": "float32 battery\n",
        "b/srv/SetMode.srv": "string mode\n---\nbool success\n",
        "b/action/Drive.action": "float32 goal_x\n---\nbool done\n---\nfloat32 left\n",
    }
    return [each.message.split(": ")[0] for each in lint_files(files, ["IDL010"]).findings]


@pytest.mark.parametrize(
    "start",
    [
        ACTION.format("self.run"),
        ACTION.format("execute_callback=self.run"),
        ACTION.format("self.drive, handle_accepted_callback=self.run"),
        ACTION.format("self.drive, cancel_callback=self.run"),
        ACTION.format("functools.partial(self.run)"),
        "self.server.register_execute_callback(self.run)",
        "self.client.send_goal_async(Drive.Goal()).add_done_callback(self.run)",
        "self.client.send_goal_async(Drive.Goal(), feedback_callback=self.run)",
        "self.create_timer(1.0, self.run)",
        "self.add_on_set_parameters_callback(self.run)",
        "self.create_subscription(Drive.Goal, 'a', self.run, 10, raw=True)",
    ],
)
def test_what_rclpy_hands_is_no_message(start: str) -> None:
    assert told(start) == []


@pytest.mark.parametrize(
    "start",
    [
        "self.later = self.run",
        "self.bus.on_goal(self.run)",
        ACTION.format("self.drive, goal_callback=self.run"),
        "self.create_subscription(self.kind, 'a', self.run, 10, raw=False)",
    ],
)
def test_annotations_count_for_what_is_handed_otherwise(start: str) -> None:
    assert told(start) == ["`my_ifs/action/Drive_Goal` has no field `request`"]


def test_a_goal_callback_is_handed_the_goal_whatever_it_says() -> None:
    start = ACTION.format("self.drive, goal_callback=self.run")
    assert told(start, "Drive", "request") == ["`my_ifs/action/Drive_Goal` has no field `request`"]
    assert told(start, "Drive.Result", "goal_x") == []

"""Calls that own classes and their objects refuse end the run, with what stands around them."""

from __future__ import annotations

import pytest

from rospkg_cli.example import BACKDROPS, existing_files, manifest, scripts, setup_py
from rospkg_cli.testing import lint_files

ROBOT = """\
from rclpy.node import Node


class Robot(Node):
    def __init__(self, speed=1.0):
        super().__init__('robot')
        self.speed = speed

    def stop(self):
        print('stop', self.speed)

    def turn(self, angle, *, fast=False):
        print(angle, fast)


class Fast(Robot):
    pass
"""
MAIN = """\
import rclpy
from my_pkg.robot import Robot
{top}

def main():
    rclpy.init()
    {main}
    late()
"""
FILES = {
    **existing_files(BACKDROPS["ament_python"]),
    "package.xml": manifest("  <exec_depend>rclpy</exec_depend>\n"),
    "setup.py": setup_py(scripts("go = my_pkg.go:main")),
    "my_pkg/robot.py": ROBOT,
}


def found(code: str, main: str, top: str = "", robot: str = ROBOT) -> list[tuple[str, str]]:
    """Return level and message of what a rule finds in the program."""
    text = MAIN.format(main="\n    ".join(main.split("\n")), top=top)
    findings = lint_files({**FILES, "my_pkg/go.py": text, "my_pkg/robot.py": robot}, [code]).findings
    return [(each.severity.value, each.message) for each in findings if each.location.path == "my_pkg/go.py"]


@pytest.mark.parametrize(
    ("call", "said"),
    [
        ("robot = Robot()\nrobot.stop(1)", "`robot.stop` takes no argument by position, and is given 1"),
        ("robot = Robot()\nrobot.turn()", "`robot.turn` needs `angle` as well"),
        ("robot = Robot()\nrobot.turn(1, slow=True)", "`robot.turn` has no `slow`"),
        ("robot = Robot(1, 2)", "`Robot` takes one argument by position, and is given 2"),
    ],
)
def test_what_an_object_of_an_own_class_refuses(call: str, said: str) -> None:
    assert found("DEP120", call) == [("error", f"{said}: the start ends here with TypeError")]
    assert [level for level, _ in found("DEP117", call)] == ["info"]


@pytest.mark.parametrize(
    "call",
    [
        "robot = Robot()\nrobot.turn(1, fast=True)",
        "robot = Robot()\nrobot.stop(*given)",
        "robot = Robot()\nrobot = other()\nrobot.stop(1)",
        "robot = Robot()\nrobot.get_name(1)",
        "robot = Robot()\ndef swap():\n    nonlocal robot\nrobot.stop(1)",
        "robot = other(Robot())\nrobot.stop(1)",
        "robot = Robot()\ntry:\n    robot.stop(1)\nexcept TypeError:\n    pass",
    ],
)
def test_what_may_be_right(call: str) -> None:
    assert found("DEP120", call, "given, other = [], print\n") == []


@pytest.mark.parametrize(
    ("old", "new"),
    [
        ("    def stop(self)", "    @classmethod\n    def stop(self)"),
        ("class Robot(Node)", "class Robot(Node, Unknown)"),
        ("        self.speed = speed", "        self.stop = speed"),
        ("        self.speed = speed", "        setattr(self, 'stop', speed)"),
        ("class Fast", "class Robot(Fast):\n    pass\n\n\nclass Fast"),
        ("    def turn", "    def __new__(cls):\n        return cls\n\n    def turn"),
    ],
)
def test_a_class_that_may_take_it(old: str, new: str) -> None:
    assert found("DEP120", "robot = Robot()\nrobot.stop(1)", robot=ROBOT.replace(old, new, 1)) == []


EMPTY = ("pass", "...", "return", "raise NotImplementedError", "raise NotImplementedError('x')")


@pytest.mark.parametrize("body", EMPTY)
def test_a_method_that_heirs_of_other_packages_define(body: str) -> None:
    robot = ROBOT.replace("print('stop', self.speed)", f'"""Stop."""\n        {body}')
    assert found("DEP120", "robot = Robot()\nrobot.stop(1)", robot=robot) == []
    robot = ROBOT.replace("self.speed = speed", body)
    assert len(found("DEP120", "robot = Robot(1, 2)", robot=robot)) == 1


def test_a_member_that_is_given_once_is_known() -> None:
    holder = "\n\nclass Holder:\n    def __init__(self):\n        self.arm = Robot(){}\n        self.arm.stop(1)\n"
    told = found("DEP120", "Holder()", top=holder.format(""))
    assert [level for level, _ in told] == ["warning"]
    assert found("DEP120", "Holder()", top=holder.format("\n        self.arm = print")) == []


CALL = "robot = Robot()\n"
STOPS = {
    "try:\n    robot.stop(1)\nexcept KeyboardInterrupt:\n    pass": "info",
    "try:\n    robot.stop(1)\nexcept (KeyboardInterrupt, SystemExit):\n    pass\nfinally:\n    print()": "info",
    "while rclpy.ok():\n    robot.stop(1)": "info",
    "if ON:\n    robot.stop(1)": "info",
    "answer = ''\nif OFF:\n    answer = input()\nif answer.lower() != 'n':\n    robot.stop(1)": "info",
    "try:\n    if ON:\n        robot.stop(1)\nexcept KeyboardInterrupt:\n    pass": "info",
    "try:\n    robot.stop(1)\nexcept (TypeError, KeyboardInterrupt):\n    pass": "error",
    "try:\n    robot.stop(1)\nexcept:\n    pass": "error",
    "try:\n    print()\nexcept KeyboardInterrupt:\n    robot.stop(1)": "error",
    "try:\n    rclpy.spin(robot)\n    robot.stop(1)\nexcept KeyboardInterrupt:\n    pass": "warning",
    "while robot.speed < 3:\n    robot.stop(1)": "error",
    "while rclpy.ok():\n    if robot.speed:\n        break\n    robot.stop(1)": "warning",
    "for each in robot.speed:\n    robot.stop(1)": "error",
    "if OFF:\n    robot.stop(1)": "error",
    "if OTHER:\n    robot.stop(1)": "error",
    "answer = ''\nif OTHER:\n    answer = input()\nif answer.lower() != 'n':\n    robot.stop(1)": "error",
}


@pytest.mark.parametrize("lines", STOPS)
def test_what_a_refused_call_leaves_by_its_exception(lines: str) -> None:
    told = found("DEP117", CALL + lines, top=SWITCHES)
    assert [level for level, message in told if "`late`" in message] == [STOPS[lines]]


SWITCHES = "ON = True\nOFF = False\nOTHER = input()\n"


NESTED = """\
class Outer:
    def __init__(self):
        self.stop(1)

    def stop(self, why):
        class Handler:
            def stop(self):
                pass

            def handle(self):
                self.stop()
                self.creat_timer()

        def turn(self):
            self.stop()

        print(why, Handler().handle(), turn)

    class Inner:
        def stop(self, one, two):
            pass

        def __init__(self):
            self.stop(1, 2)
"""


def test_self_of_an_inner_class_is_no_object_of_the_outer_one() -> None:
    assert found("DEP120", "print(Outer().stop(1), Outer.Inner())", top=NESTED) == []
    assert found("DEP120", "print(Outer())", top=NESTED.replace("Outer:", "Outer(Robot):")) == []
    assert len(found("DEP120", "print(Outer())", top=NESTED.replace("self.stop(1)", "self.stop()"))) == 1

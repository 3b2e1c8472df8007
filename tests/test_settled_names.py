"""What stands under a comparison that never holds, as a name only ever has other constants, nobody comes to."""

from __future__ import annotations

import ast

import pytest

from rospkg_cli.example import BACKDROPS, existing_files, manifest, scripts, setup_py
from rospkg_cli.languages.python.settled_names import answer, constant_of
from rospkg_cli.testing import lint_files

PYTHON = {
    **existing_files(BACKDROPS["ament_python"]),
    "package.xml": manifest("  <exec_depend>rclpy</exec_depend>\n"),
    "setup.py": setup_py(scripts("talker = my_pkg.talker:main")),
}
NODE = """\
import rclpy
from rclpy.node import Node

{top}


class Talker(Node):
    def __init__(self):
        super().__init__('talker')
        {start}
        while rclpy.ok():
            if {test}:
                self.go()
            {end}

    def go(self):
        lost()


def main():
    rclpy.init()
    rclpy.spin(Talker())
"""


def level(test: str, start: str = "pass", end: str = "pass", top: str = "") -> str:
    files = {**PYTHON, "my_pkg/talker.py": NODE.format(test=test, start=start, end=end, top=top)}
    return next(each.severity.value for each in lint_files(files, ["DEP117"]).findings if "`lost`" in each.message)


@pytest.mark.parametrize(
    ("test", "expected"),
    [
        ("step == 50", "info"),
        ("step != 0", "info"),
        ("step > 3", "info"),
        ("step is None", "info"),
        ("step", "info"),
        ("not step", "warning"),
        ("step == 0", "warning"),
        ("step < -1 or self.get_name()", "warning"),
        ("step < -1 and self.get_name()", "info"),
        ("step == self.get_name()", "warning"),
        ("step < 'a'", "warning"),
        ("0 < step < 3", "warning"),
    ],
)
def test_a_local_name_that_is_never_counted_on(test: str, expected: str) -> None:
    assert level(test, "step = 0") == expected


@pytest.mark.parametrize(
    "end",
    ["step += 1", "step = step + 1", "step = 50", "step: int = 50", "del step", "for step in [1]: pass", "import step",
     "with self as step: pass", "print(step := 50)", "def step(): pass"],
)  # fmt: skip
def test_a_local_name_that_changes(end: str) -> None:
    assert level("step == 50", "step = 0", end) == "warning"


def test_several_constants() -> None:
    assert level("step == 'c'", "step = 'a'", "step = 'b'") == "info"
    assert level("step == 'b'", "step = 'a'", "step = 'b'") == "warning"
    assert level("step", "step = 1", "step = 0") == "warning"


def test_an_inner_function_that_counts() -> None:
    inner = "def count():\n                nonlocal step\n                step += 1"
    assert level("step == 50", "step = 0", inner) == "warning"


@pytest.mark.parametrize(
    ("test", "start", "expected"),
    [
        ("self.mode == 'real'", "self.mode = 'sim'", "info"),
        ("self.mode == 'real'", "self.mode = 'sim'; self.mode = self.get_name()", "warning"),
        ("self.mode == 'real'", "self.mode = 'sim'; other = self; other.mode = 'real'", "warning"),
        ("self.mode == 'real'", "self.mode = 'sim'; setattr(self, 'mode', 'real')", "warning"),
        ("self.mode is not None", "self.mode = None", "info"),
        ("self.mode > 2", "self.mode = 0; self.mode += 1", "warning"),
    ],
)
def test_a_member(test: str, start: str, expected: str) -> None:
    assert level(test, start) == expected


@pytest.mark.parametrize(
    ("top", "expected"),
    [
        ("MODE = 'sim'", "info"),
        ("MODE = input()", "warning"),
        ("MODE = 'sim'\nMODE = 'real'", "warning"),
        ("MODE = 'sim'\n\n\ndef turn():\n    global MODE\n    MODE = 'real'", "warning"),
        ("MODE = 'sim'\n\n\ndef turn(MODE):\n    pass", "warning"),
    ],
)
def test_a_name_of_the_module(top: str, expected: str) -> None:
    assert level("MODE == 'real'", top=top) == expected


def test_the_other_branch_of_what_always_holds() -> None:
    assert level("step == 0:\n                pass\n            elif True", "step = 0") == "info"


def test_what_is_no_plain_comparison() -> None:
    assert answer(0, ast.In(), ast.Constant(value="a")) is None
    assert constant_of(None) is None
    assert constant_of(ast.parse("-1", mode="eval").body) == (int, -1)

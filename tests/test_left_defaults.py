"""A parameter that every call leaves at its default is a switch that nothing throws."""

from __future__ import annotations

import pytest

from rospkg_cli.example import BACKDROPS, existing_files, manifest, scripts, setup_py
from rospkg_cli.testing import lint_files

PACKAGE = {
    **existing_files(BACKDROPS["ament_python"]),
    "package.xml": manifest("  <exec_depend>rclpy</exec_depend>\n"),
    "setup.py": setup_py(scripts("talker = my_pkg.talker:main")),
}
CODE = """\
import functools

import rclpy


class Arm:
    def __init__(self, {more}):
        self.plot = plot
        {start}

    def move(self):
        {move}


{rest}
def main(sim=False):
    rclpy.init()
    arm = {make}
    arm.move()
    {main}
"""


def level(**parts: str) -> str:
    texts = {
        "more": "plot=False",
        "start": "pass",
        "move": "pass",
        "rest": "",
        "make": "Arm()",
        "main": "pass",
        **parts,
    }
    files = {**PACKAGE, "my_pkg/talker.py": CODE.format(**texts)}
    found = lint_files(files, ["DEP117"]).findings
    return next((each.severity.value for each in found if "`lost`" in each.message), "")


@pytest.mark.parametrize(
    "parts",
    [
        {"start": "if plot:\n            lost()"},
        {"start": "if plot:\n            lost()", "more": "*, plot=False"},
        {"start": "if plot is not None:\n            lost()", "more": "size=1, plot=None", "make": "Arm(2)"},
        {"start": "if plot == 'all':\n            lost()", "more": "plot=''"},
        {"move": "if self.plot:\n            lost()"},
        {"main": "if sim:\n        lost()"},
        {"main": "draw(1)", "rest": "def draw(x, deep=False):\n    if deep:\n        lost()\n\n\n"},
    ],
)
def test_what_no_call_gives(parts: dict[str, str]) -> None:
    assert level(**parts) == "info"


@pytest.mark.parametrize(
    "parts",
    [
        {"make": "Arm(True)"},
        {"make": "Arm(plot=rclpy.ok())"},
        {"make": "Arm(*[True])"},
        {"make": "Arm(**{'plot': True})"},
        {"make": "functools.partial(Arm, True)()"},
        {"more": "plot=False, size=1", "make": "Arm(size=2, plot=True)"},
        {"more": "plot=True"},
        {"more": "plot=rclpy"},
        {"rest": "class Other(Arm):\n    pass\n\n\n"},
        {"rest": "NAMES = ['Arm']\n\n\n"},
    ],
)
def test_what_a_call_may_give(parts: dict[str, str]) -> None:
    assert level(**{"start": "if plot:\n            lost()", **parts}) == "warning"


def test_a_member_that_is_set_elsewhere() -> None:
    move = "if self.plot:\n            lost()"
    assert level(move=move, main="arm.plot = True") == "warning"
    assert level(move=move, start="plot = len('words')\n        self.plot = plot") == "warning"

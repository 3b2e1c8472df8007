"""Python that nobody comes to: behind a parameter, an option or a variable that is off, or in a program given up."""

from __future__ import annotations

import pytest

from rospkg_cli.example import SETUP_CFG, SETUP_PY_FOR_ALL, manifest
from rospkg_cli.testing import lint_files

CODES = ("DEP109", "DEP117", "DEP120", "IDL010", "IDL011")
NODE = """\
import argparse
import os

import rclpy
from rclpy.node import Node
from std_msgs.msg import String


class Talker(Node):
    def __init__(self):
        super().__init__('talker')
        self.debug = self.declare_parameter('debug', False).value
        self.mode = self.declare_parameter('mode', 'real').value
{init}

    def tick(self):
        {fault}


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument('--show-all', action='store_true')
    args = parser.parse_args()
    rclpy.init()
{main}    rclpy.spin(Talker())
"""
TICKS = "            self.create_timer(1.0, self.tick)\n"
ON = f"        if self.debug:\n{TICKS}"
FAULTS = [
    ("DEP109", "from my_pkg import nothing"),
    ("DEP117", "json.loads('{}')"),
    ("DEP120", "self.creat_timer(1.0, print)"),
    ("IDL010", "String().dat = 'a'"),
    ("IDL011", "from std_msgs.msg import Sting"),
]
RUN = {"README.md": "    ros2 run my_pkg talker\n"}


def tree(text: str, **others: str) -> dict[str, str]:
    programs = "    entry_points={'console_scripts': ['talker = my_pkg.talker:main', 'other = my_pkg.other:main']},\n"
    return {
        "package.xml": manifest("  <exec_depend>rclpy</exec_depend>\n  <exec_depend>std_msgs</exec_depend>\n"),
        "setup.py": SETUP_PY_FOR_ALL.replace("    license=", f"{programs}    license="),
        "setup.cfg": SETUP_CFG,
        "resource/my_pkg": "",
        "my_pkg/__init__.py": "",
        "my_pkg/other.py": "def main():\n    print('here')\n",
        "my_pkg/talker.py": text,
        **others,
    }


def levels(files: dict[str, str]) -> list[tuple[str, str]]:
    return [(each.code, each.severity.value) for each in lint_files(files, CODES).findings]


def node(init: str = ON, fault: str = FAULTS[1][1], main: str = "") -> str:
    return NODE.format(init=init, fault=fault, main=main)


@pytest.mark.parametrize(("code", "fault"), FAULTS)
def test_a_callback_that_only_a_parameter_registers(code: str, fault: str) -> None:
    assert levels(tree(node(fault=fault), **RUN)) == [(code, "info")]
    for each in ({"config/a.yaml": "talker:\n  ros__parameters:\n    debug: true\n"}, {"README.md": "Try `debug`.\n"}):
        assert levels(tree(node(fault=fault), **{**RUN, **each})) == [(code, "warning")]
    assert levels(tree(node(init=TICKS[4:], fault=fault), **RUN)) in ([(code, "warning")], [(code, "error")])


SHOWS = "    if {}:\n        json.loads('{{}}')\n"


@pytest.mark.parametrize(
    ("condition", "page", "level"),
    [
        ("args.show_all", "", "info"),
        ("args.show_all", "Add `--show-all` for more.\n", "warning"),
        ("not args.show_all", "", "warning"),
        ("os.environ.get('SHOW')", "", "info"),
        ("os.getenv('SHOW', '0') == '1'", "", "info"),
        ("os.environ.get('SHOW')", "    SHOW=1 ros2 run my_pkg talker\n", "warning"),
        ("os.environ.get('SHOW', '1')", "", "warning"),
        ("not os.environ.get('SHOW')", "", "warning"),
    ],
)
def test_an_option_or_a_variable_that_nothing_gives(condition: str, page: str, level: str) -> None:
    text = node(init="        pass\n", fault="pass", main=SHOWS.format(condition))
    assert levels(tree(text, **RUN, **({"doc/more.md": page} if page else {}))) == [("DEP117", level)]


def test_a_function_that_calls_itself_under_a_switch() -> None:
    again = "self.creat_timer(1.0, self.tick)"
    assert levels(tree(node(fault=again), **RUN)) == [("DEP120", "info")]


AT_START = node(init="        json.loads('{}')\n", fault="pass")


@pytest.mark.parametrize(
    ("head", "page", "level"),
    [
        ("", "`talker` is deprecated.\n", "info"),
        ("", "| talker | not working yet |\n", "info"),
        ("", "Run `talker`. The other node is deprecated.\n", "error"),
        ("", "`talker` replaces the node of last year.\n", "error"),
        ("# WIP\n", "", "info"),
        ('"""Deprecated: use other."""\n', "", "info"),
        ('"""Not finished."""\n', "", "info"),
        ('"""Replaces the deprecated node."""\n', "", "error"),
        ('"""Unused topics are left out."""\n', "", "error"),
        ("# WIP\n", "    ros2 run my_pkg talker\n", "error"),
    ],
)
def test_a_program_that_a_text_gives_up(head: str, page: str, level: str) -> None:
    assert levels(tree(head + AT_START, **{"README.md": page})) == [("DEP117", level)]

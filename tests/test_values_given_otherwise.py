"""PRM003, PRM006, PRM007: values that launch files replace, and what a comment, a page or an old file says of them."""

from __future__ import annotations

import pytest

from rospkg_cli.example import SETUP_CFG, SETUP_PY_FOR_ALL, manifest
from rospkg_cli.testing import lint_files

CODES = ("PRM003", "PRM006", "PRM007")
NODE = """\
import rclpy
from rclpy.node import Node


class Talker(Node):
    def __init__(self):
        super().__init__('talker')
        self.rate = self.declare_parameter('rate', 10.0).value
        self.frame = self.declare_parameter('global_frame', 'map').value
        self.verbose = self.declare_parameter('verbose', False).value
        print(self.rate, self.frame, self.verbose)
{more}

def main():
    rclpy.init()
    rclpy.spin(Talker())
"""
GOOD = "talker:\n  ros__parameters:\n    rate: 50.0\n    global_frame: odom\n    verbose: true\n"
INT, SLIP = GOOD.replace("50.0", "50"), GOOD.replace("global_frame", "global_flame")
RENAMED = GOOD.replace("talker", "talkr")
SHARE = "$(find-pkg-share my_pkg)/config"
LAUNCH = '<launch>\n  <node pkg="my_pkg" exec="talker" name="talker">\n{}  </node>\n</launch>\n'
FILE = f'    <param from="{SHARE}/{{}}.yaml"/>\n'
VALUE = '    <param name="{}" value="{}"/>\n'


def levels(text: str, given: str = "", more: str = "", launch: str = "launch/a.launch.xml", **others: str) -> list[str]:
    programs = "    entry_points={'console_scripts': ['talker = my_pkg.talker:main', 'other = my_pkg.other:main']},\n"
    files = {
        "package.xml": manifest("  <exec_depend>rclpy</exec_depend>\n"),
        "setup.py": SETUP_PY_FOR_ALL.replace("    license=", f"{programs}    license="),
        "setup.cfg": SETUP_CFG,
        "resource/my_pkg": "",
        "my_pkg/__init__.py": "",
        "my_pkg/other.py": "def main():\n    pass\n",
        "my_pkg/talker.py": NODE.format(more=more),
        "config/robot.yaml": text,
        launch: LAUNCH.format(FILE.format("robot") + given),
        **others,
    }
    return [each.severity.value for each in lint_files(files, CODES).findings]


@pytest.mark.parametrize(
    ("text", "given", "expected"),
    [
        (INT, "", "warning"),
        (INT, VALUE.format("rate", "5.0"), "info"),
        (INT, VALUE.format("verbose", "true"), "warning"),
        (INT, FILE.format("later"), "info"),
        (INT, FILE.format("others"), "warning"),
        (SLIP, "", "warning"),
        (SLIP, VALUE.format("global_frame", "base"), "info"),
        (SLIP, VALUE.format("rate", "5.0"), "warning"),
    ],
)
def test_what_launch_files_give_later(text: str, given: str, expected: str) -> None:
    later = {"config/later.yaml": "talker:\n  ros__parameters:\n    rate: 5.0\n"}
    others = {"config/others.yaml": "talker:\n  ros__parameters:\n    verbose: true\n"}
    assert levels(text, given, **later, **others) == [expected]


@pytest.mark.parametrize(
    ("text", "comment", "expected"),
    [
        (SLIP, "unused", "info"),
        (SLIP, "not supported yet", "info"),
        (SLIP, "deprecated", "info"),
        (SLIP, "the frame of the map", "warning"),
        (SLIP, "change this to your frame", "warning"),
        (INT, "deprecated", "warning"),
        (RENAMED, "not used at the moment", "info"),
        (RENAMED, "example: rename it to your node", "info"),
        (RENAMED, "the first node", "warning"),
    ],
)
def test_what_a_comment_says(text: str, comment: str, expected: str) -> None:
    word = next(each for each in ("flame", "talkr", "rate") if each in text)
    above = next(line for line in text.split("\n") if word in line)
    indent = above[: len(above) - len(above.lstrip())]
    assert levels(text.replace(above, f"{indent}# {comment}\n{above}")) == [expected]


@pytest.mark.parametrize(
    ("page", "expected"),
    [
        ("    ros2 run my_pkg talker --ros-args -r __node:=talkr --params-file robot.yaml\n", "info"),
        ("    ros2 run my_pkg talker --ros-args -r __node:=talkrs\n", "warning"),
    ],
)
def test_a_node_that_a_page_starts_under_another_name(page: str, expected: str) -> None:
    assert levels(RENAMED, **{"README.md": page}) == [expected]


@pytest.mark.parametrize(("folder", "expected"), [("launch/old", "info"), ("launch", "warning")])
def test_a_launch_file_that_is_laid_aside(folder: str, expected: str) -> None:
    assert levels(RENAMED, launch=f"{folder}/a.launch.xml") == [expected]


GETS = "        self.size = self.get_parameter('{}').value\n        print(self.size)\n"


@pytest.mark.parametrize(
    ("default", "page", "expected"),
    [("False", "", "info"), ("True", "", "warning"), ("False", "Try `draw`.\n", "warning")],
)
def test_a_parameter_that_is_got_behind_a_switch(default: str, page: str, expected: str) -> None:
    lines = f"        self.draw = self.declare_parameter('draw', {default}).value\n        if self.draw:\n"
    gets = GETS.format("siz").replace("        ", "            ")
    assert levels(GOOD, more=lines + gets, **{"README.md": page}) == [expected]


@pytest.mark.parametrize(
    ("head", "page", "expected"),
    [
        ("", "", "error"),
        ("# WIP\n", "", "info"),
        ("", "`talker` is deprecated.\n", "info"),
        ("", "    ros2 run my_pkg other\n", "warning"),
        ("", "    ros2 run my_pkg talker\n", "error"),
    ],
)
def test_a_program_that_nobody_starts(head: str, page: str, expected: str) -> None:
    gets = GETS.format("rat")
    text = head + NODE.format(more=gets).replace("self.rate = ", "").replace("self.rate, ", "")
    files = {"my_pkg/talker.py": text, "config/robot.yaml": "", "launch/a.launch.xml": "<launch/>\n"}
    assert levels("", **files, **{"README.md": page}) == [expected]

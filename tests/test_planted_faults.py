"""What a page says to be wrong on purpose is an exercise: an info, whatever it is."""

from __future__ import annotations

import pytest

from rospkg_cli.example import BACKDROPS, existing_files, manifest
from rospkg_cli.testing import lint_files

PLAIN = existing_files(BACKDROPS["ament_python"])
LOST = {**PLAIN, "my_pkg/talker.py": "import rowan_of_nobody, numpy\n"}
ENTRY = "    entry_points={'console_scripts': ['talker = my_pkg.talker:main']},\n"
NODE = """\
import rclpy.node


class Talker(rclpy.node.Node):
    def __init__(self):
        super().__init__('talker')
        self.declare_parameter('min_point', 10)
        self.points = self.get_parameter('min_point').value
"""
LAUNCH = """\
from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription([Node(package='my_pkg', executable='talker', parameters=[{'min_points': 1}])])
"""


def levels(files: dict[str, str], code: str) -> set[str]:
    return {each.severity.value for each in lint_files(files, [code]).findings}


@pytest.mark.parametrize(
    ("line", "expected"),
    [
        ("Source: talker.py - intentional defects are present.", "info"),
        ("Students look for the bugs that were placed on purpose.", "info"),
        ("This code is deliberately broken: repair it.", "info"),
        ("The package is broken on purpose.", "info"),
        ("Debug a node with intentional bugs.", "info"),
        ("Find a bug in this code? Tell us.", "warning"),
        ("The node injects intentional defects into the scan.", "warning"),
        ("The launch file leaves this out on purpose.", "warning"),
        ("The gripper is faulty by design of the maker; the driver of this package waits.", "warning"),
        ("No intentional bugs are in this code.", "warning"),
    ],
)
def test_what_a_page_of_the_package_says(line: str, expected: str) -> None:
    assert levels({**LOST, "README.md": f"# Talker\n{line}\n"}, "DEP101") == {expected}


@pytest.mark.parametrize(
    ("line", "expected"),
    [
        ("`talker_lab` has intentional bugs in its code.", "info"),
        ("This workspace is broken on purpose.", "info"),
        ("`other_lab` has intentional bugs in its code.", "warning"),
    ],
)
def test_what_a_page_above_says(line: str, expected: str) -> None:
    files = {f"src/talker_lab/{path}": text for path, text in LOST.items()}
    assert levels({**files, "README.md": f"{line}\n"}, "DEP101") == {expected}


def test_the_other_place_lies_in_such_a_package() -> None:
    setup = PLAIN["setup.py"].replace("    license=", f"{ENTRY}    license=")
    files = {f"a/{path}": text for path, text in {**PLAIN, "setup.py": setup, "my_pkg/talker.py": NODE}.items()}
    files |= {"b/package.xml": manifest("  <exec_depend>my_pkg</exec_depend>\n", "ament_python", "user")}
    files |= {"b/setup.py": PLAIN["setup.py"].replace("my_pkg", "user"), "b/launch/a.launch.py": LAUNCH}
    assert levels(files, "PRM007") == {"warning"}
    assert levels({**files, "a/README.md": "The node has intentional defects in its code.\n"}, "PRM007") == {"info"}
    assert levels({**files, "a/README.md": "A node.\n"}, "PRM007") == {"warning"}


@pytest.mark.parametrize(
    ("text", "hint"),
    [
        ("PARAMETERS = {'min_points': 1}\n", "the tests of `my_pkg` have `min_points` too"),
        ("PARAMETERS = {'min_points': 1, 'min_point': 2}\n", "did you mean `min_point`?"),
        ("PARAMETERS = {}\n", "did you mean `min_point`?"),
    ],
)
def test_the_tests_of_the_package_tell_which_name_is_the_slip(text: str, hint: str) -> None:
    setup = PLAIN["setup.py"].replace("    license=", f"{ENTRY}    license=")
    files = {"setup.py": setup, "my_pkg/talker.py": NODE, "launch/a.launch.py": LAUNCH, "test/test_talker.py": text}
    (found,) = lint_files({**PLAIN, **files}, ["PRM007"]).findings
    assert hint in found.message

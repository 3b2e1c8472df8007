"""Launch files of which a text says that nobody is to start them any more, or yet."""

from __future__ import annotations

import pytest

from rospkg_cli.example import BACKDROPS, existing_files
from rospkg_cli.testing import lint_files

PYTHON = """\
{}
from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription([Node(package='my_pkg', executable='joystick')])
"""
XML = '{}\n<launch>\n  <node pkg="my_pkg" exec="joystick"/>\n</launch>\n'
INCLUDE = '<launch>\n  <include file="$(find-pkg-share my_pkg)/launch/slam.launch.{}"/>\n</launch>\n'
RULE = "install(DIRECTORY launch DESTINATION share/${PROJECT_NAME})\nament_package"


def level(files: dict[str, str]) -> str:
    there = existing_files(BACKDROPS["ament_cmake"])
    there["CMakeLists.txt"] = there["CMakeLists.txt"].replace("ament_package", RULE)
    (found,) = lint_files({**there, **files}, ["LCH002"]).findings
    return found.severity.value


@pytest.mark.parametrize(
    ("head", "expected"),
    [
        ("DEPRECATED: use bringup.launch.py", "info"),
        ("This launch file is deprecated, use bringup.launch.py", "info"),
        ("This launch file is no longer used", "info"),
        ("This file no longer works.", "info"),
        ("WIP", "info"),
        ("The launch file does not work yet", "info"),
        ("Starts the joystick, and replaces the deprecated teleop", "error"),
        ("This launch file is used by the bringup", "error"),
    ],
)
def test_what_the_file_says_itself(head: str, expected: str) -> None:
    assert level({"launch/slam.launch.py": PYTHON.format(f"# {head}")}) == expected
    assert level({"launch/slam.launch.py": PYTHON.format(f'"""{head}"""')}) == expected
    assert level({"launch/slam.launch.xml": XML.format(f"<!-- {head} -->")}) == expected
    included = {"launch/slam.launch.xml": XML.format(f"<!-- {head} -->"), "launch/a.launch.xml": INCLUDE.format("xml")}
    assert level(included) == "error"
    started = {"README.md": "Run `ros2 launch my_pkg slam.launch.py`.\n"}
    assert level({"launch/slam.launch.py": PYTHON.format(f"# {head}"), **started}) == "error"


@pytest.mark.parametrize(
    ("page", "expected"),
    [
        ("`slam.launch.py` is work in progress and does not run yet.\n", "info"),
        ("- slam.launch.py (deprecated)\n", "info"),
        ("- slam.launch.py: maps a room\n- old.launch.py (deprecated)\n", "error"),
        ("`slam.launch.py` is not finished.\n\n    ros2 launch my_pkg slam.launch.py\n", "error"),
    ],
)
def test_what_a_page_says(page: str, expected: str) -> None:
    assert level({"launch/slam.launch.py": PYTHON.format(""), "README.md": page}) == expected


NAMELESS = """\
import os

from launch import LaunchDescription

DEBUG = {}


def generate_launch_description():
    if {}:
        print(pprint.pformat(dict(os.environ)))
    return LaunchDescription([])
"""


@pytest.mark.parametrize(
    ("value", "test", "expected"),
    [
        ("False", "DEBUG", "info"),
        ("False", "False", "info"),
        ("True", "not DEBUG", "info"),
        ("True", "DEBUG", "warning"),
        ("False", "os.environ.get('DEBUG')", "warning"),
    ],
)
def test_a_name_in_a_branch_that_is_never_taken(value: str, test: str, expected: str) -> None:
    there = {**existing_files(BACKDROPS["ament_cmake"]), "launch/a.launch.py": NAMELESS.format(value, test)}
    there["CMakeLists.txt"] = there["CMakeLists.txt"].replace("ament_package", RULE)
    (found,) = lint_files(there, ["LCH013"]).findings
    assert found.severity.value == expected

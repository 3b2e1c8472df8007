"""LCH001: Python files among launch files that nobody gives to `ros2 launch`."""

from __future__ import annotations

import pytest

from rospkg_cli.example import BACKDROPS, existing_files
from rospkg_cli.testing import lint_files

PYTHON = existing_files(BACKDROPS["ament_python"])
CAMERA = "from launch_ros.actions import Node\n\n\ndef camera():\n    return Node(package='a', executable='b')\n"
USER = """\
from launch import LaunchDescription
{}


def generate_launch_description():
    return LaunchDescription([])
"""


def levels(text: str, **others: str) -> list[str]:
    files = {f"launch/{name}.launch.py": other for name, other in others.items()}
    found = lint_files({**PYTHON, "launch/camera_launch.py": text, **files}, ["LCH001"]).findings
    return [each.severity.value for each in found]


@pytest.mark.parametrize(
    ("line", "expected"),
    [
        ("from camera_launch import camera", []),
        ("from .camera_launch import camera", []),
        ("from my_pkg.launch import camera_launch", []),
        ("import os, camera_launch", []),
        ("import importlib\ncamera = importlib.import_module('my_pkg.camera_launch').camera", []),
        ("import runpy\nrunpy.run_path('launch/camera_launch.py')", []),
        ("import camera_launcher", ["error"]),
        ("# from camera_launch import camera", ["error"]),
        ("", ["error"]),
    ],
)
def test_what_another_file_imports_is_a_module(line: str, expected: list[str]) -> None:
    assert levels(CAMERA, user=USER.format(line)) == expected


@pytest.mark.parametrize(
    ("head", "expected"),
    [
        ("from better import launch_this\n\n\n@launch_this\ndef main():\n    pass\n", []),
        ("import better\n\n\n@better.launch_this(ui=True)\ndef main():\n    pass\n", []),
        ("from .better import launch_this\n\n\n@launch_this\nasync def main():\n    pass\n", []),
        ("import functools\nimport launch\n\n\n@functools.cache\ndef main():\n    pass\n", ["error"]),
        ("import launch\n\n\n@[print][0]\ndef main():\n    pass\n", ["error"]),
    ],
)
def test_a_decorator_of_another_package_may_make_the_entry_point(head: str, expected: list[str]) -> None:
    assert levels(head) == expected


def test_a_file_that_launches_by_itself() -> None:
    assert levels("from launch import LaunchService\n\nservice = LaunchService()\nservice.run()\n") == []


def test_a_file_without_launch_describes_nothing() -> None:
    assert levels("RATE = 2\n\n\ndef rate():\n    return RATE\n") == ["info"]

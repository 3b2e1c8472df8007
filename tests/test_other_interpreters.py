"""Files that another interpreter runs, inside of a program or on a microcontroller: rosdep installs nothing for it."""

from __future__ import annotations

import pytest

from rospkg_cli.example import BACKDROPS, existing_files, manifest
from rospkg_cli.testing import lint_files


def levels(text: str) -> list[str]:
    files = {
        **existing_files(BACKDROPS["ament_python"]),
        "package.xml": manifest("  <exec_depend>rclpy</exec_depend>\n"),
        "my_pkg/talker.py": f"{text}\nimport serial\n",
    }
    return [each.severity.value for each in lint_files(files, ["DEP101"]).findings]


@pytest.mark.parametrize(
    "text", ["import bpy", "from omni.isaac.kit import App", "from controller import Robot", "from machine import Pin"]
)
def test_what_another_interpreter_runs(text: str) -> None:
    assert levels(text) == ["info"]


@pytest.mark.parametrize(
    "text",
    [
        "import json",
        "from controller import Arm",
        "from .bpy import a",
        "try:\n    import bpy\nexcept ImportError:\n    0",
    ],
)
def test_what_ros_runs(text: str) -> None:
    assert levels(text) == ["warning"]

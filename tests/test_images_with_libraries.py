"""An image of others that the repository builds on may bring a library of Python: an info (DEP101)."""

from __future__ import annotations

import pytest

from rospkg_cli.example import BACKDROPS, existing_files, manifest
from rospkg_cli.testing import lint_files


@pytest.mark.parametrize(
    ("image", "module", "level"),
    [
        ("dustynv/ros:humble-pytorch", "cv2", "info"),
        ("ros:humble", "cv2", "warning"),
        ("osrf/ros:humble-desktop", "cv2", "warning"),
        ("dustynv/ros:humble-pytorch", "sensor_msgs.msg", "warning"),
    ],
)
def test_levels(image: str, module: str, level: str) -> None:
    package = {f"src/my_pkg/{path}": text for path, text in existing_files(BACKDROPS["ament_python"]).items()}
    own = {"src/my_pkg/package.xml": manifest(), "src/my_pkg/my_pkg/node.py": f"import {module}\n"}
    files = {**package, **own, "Dockerfile": f"FROM {image}\nRUN . /opt/ros/humble/setup.sh && colcon build\n"}
    (only,) = lint_files(files, ["DEP101"]).findings
    assert only.severity.value == level
    assert ("`Dockerfile` builds on `dustynv/ros`, which may bring it" in only.message) is (level == "info")

"""What a repository has pip install is there without package.xml: an info (DEP101)."""

from __future__ import annotations

import pytest

from rospkg_cli.example import BACKDROPS, existing_files, manifest
from rospkg_cli.testing import lint_files

NODE = "import serial\nimport cv2\nimport rclpy\n"
DOCKERFILE = "FROM ros:jazzy\nRUN apt install x && pip3 install --no-cache-dir 'pyserial>=3' \\\n    opencv-python\n"


@pytest.mark.parametrize(
    ("files", "levels"),
    [
        ({}, {"serial": "warning", "opencv": "warning", "rclpy": "warning"}),
        (
            {"src/my_pkg/requirements.txt": "# pyserial\nopencv-python==4.9\nrclpy\n"},
            {"serial": "warning", "opencv": "info", "rclpy": "warning"},
        ),
        ({"requirements.txt": "PySerial >= 3.5\n"}, {"serial": "info", "opencv": "warning", "rclpy": "warning"}),
        ({"docker/Dockerfile": DOCKERFILE}, {"serial": "info", "opencv": "info", "rclpy": "warning"}),
        ({"Dockerfile": "RUN apt install pyserial\n"}, {"serial": "warning", "opencv": "warning", "rclpy": "warning"}),
    ],
)
def test_what_pip_installs(files: dict[str, str], levels: dict[str, str]) -> None:
    package = {f"src/my_pkg/{path}": text for path, text in existing_files(BACKDROPS["ament_python"]).items()}
    tree = {**package, "src/my_pkg/package.xml": manifest(), "src/my_pkg/my_pkg/node.py": NODE, **files}
    found = lint_files(tree, ["DEP101"]).findings
    assert {each.message.split("`")[1].removeprefix("python3-"): each.severity.value for each in found} == levels

"""Meshes that are not there, and whose folder a page or a script has people fetch, unpack or copy."""

from __future__ import annotations

import pytest

from rospkg_cli.example import BACKDROPS, CMAKE, existing_files
from rospkg_cli.testing import lint_files

INSTALLS = CMAKE.replace(
    "ament_package", "install(DIRECTORY launch meshes urdf DESTINATION share/${PROJECT_NAME})\nament_package"
)
ROBOT = """\
<robot name="robot">
  <link name="base">
    <visual>
      <geometry>
        <mesh filename="package://my_pkg/meshes/base.stl"/>
      </geometry>
    </visual>
  </link>
</robot>
"""
SHOW = '<launch>\n  <let name="model" value="$(find-pkg-share my_pkg)/urdf/robot.urdf"/>\n</launch>\n'
KEPT = {"meshes/.gitkeep": ""}
WHEEL = {"meshes/wheel.stl": "solid wheel\n"}


def level(told: dict[str, str], more: dict[str, str]) -> str:
    files = {**existing_files(BACKDROPS["ament_cmake"]), "CMakeLists.txt": INSTALLS, "urdf/robot.urdf": ROBOT}
    (found,) = lint_files({**files, "launch/a.launch.xml": SHOW, **told, **more}, ["URD002"]).findings
    return found.severity.value


@pytest.mark.parametrize(
    ("told", "expected"),
    [
        ({"README.md": "Download the archive and unzip it into `my_pkg/meshes`.\n"}, "info"),
        ({"README.md": "Download the meshes from our server.\n"}, "info"),
        ({"README.md": "The meshes are drawn by Ada.\n"}, "warning"),
        ({"README.md": "Download the driver from our server.\n"}, "warning"),
        ({"README.md": "Download the mesh-tools from our server.\n"}, "warning"),
        ({"setup.sh": "wget -P src/my_pkg/meshes https://example.org/base\n"}, "info"),
    ],
)
def test_a_folder_that_is_fetched(told: dict[str, str], expected: str) -> None:
    assert level(told, KEPT) == expected
    assert level(told, WHEEL) == "warning"


@pytest.mark.parametrize(
    ("line", "expected"),
    [
        ("cp -r /tmp/cad/meshes src/my_pkg/", "info"),
        ("cp -a ../cad/meshes .", "info"),
        ("ln -s ../cad/meshes src/my_pkg/meshes", "info"),
        ("cp /tmp/cad/notes src/my_pkg/meshes.txt", "warning"),
        ("# cp -r /tmp/cad/meshes src/my_pkg/", "warning"),
    ],
)
def test_a_folder_that_is_copied(line: str, expected: str) -> None:
    assert level({"setup.sh": f"#!/bin/bash\n{line}\n"}, WHEEL) == expected

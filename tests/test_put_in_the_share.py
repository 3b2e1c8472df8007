"""Folders and files that a script or a container puts where a launch file looks, without the build."""

from __future__ import annotations

import pytest

from rospkg_cli.example import BACKDROPS, CMAKE, existing_files
from rospkg_cli.testing import lint_files

LAUNCH = """\
<launch>
  <node pkg="demo_nodes_cpp" exec="talker"><param from="$(find-pkg-share my_pkg)/config/a.yaml"/></node>
</launch>
"""
SHARE = "/ws/install/my_pkg/share/my_pkg"


def level(told: dict[str, str], folders: str, name: str) -> str:
    rule = f"install(DIRECTORY {folders} DESTINATION share/${{PROJECT_NAME}})\nament_package"
    files = {**existing_files(BACKDROPS["ament_cmake"]), "CMakeLists.txt": CMAKE.replace("ament_package", rule)}
    files |= {"launch/a.launch.xml": LAUNCH, f"config/{name}.yaml": "talker:\n  ros__parameters:\n    rate: 2.0\n"}
    (found,) = lint_files({**files, **told}, ["CMK101", "LCH003"]).findings
    return found.severity.value


@pytest.mark.parametrize(
    ("told", "expected"),
    [
        ({"install.sh": f"cp -r src/my_pkg/config {SHARE}/\n"}, "info"),
        ({"install.sh": f"# cp -r src/my_pkg/config {SHARE}/\n"}, "error"),
        ({"install.sh": f"cp -r src/my_pkg/maps {SHARE}/\n"}, "error"),
        ({"install.sh": "cp -r src/my_pkg/config /ws/install/other/share/other/\n"}, "error"),
        ({"Dockerfile": f"FROM ros:jazzy\nCOPY my_pkg/config {SHARE}/config\n"}, "info"),
        ({"docker-compose.yml": f"services:\n  a:\n    volumes:\n      - ./config:{SHARE}/config\n"}, "info"),
        ({"docker-compose.yml": "services:\n  a:\n    volumes:\n      - ./config:/etc/config\n"}, "error"),
    ],
)
def test_a_folder(told: dict[str, str], expected: str) -> None:
    assert level(told, "launch", "a") == expected


@pytest.mark.parametrize(
    ("told", "expected"),
    [
        (
            {"docker-compose.yml": f"services:\n  a:\n    volumes:\n    - ./a:{SHARE}/config/a.yaml:ro\n"},
            "info",
        ),
        ({"docker-compose.yml": "services:\n  a:\n    volumes:\n      - ./lab.yaml:/etc/b.yaml\n"}, "warning"),
        ({"run.sh": f"docker run --mount type=bind,source=/lab.yaml,target={SHARE}/config/a.yaml robot\n"}, "info"),
    ],
)
def test_a_file(told: dict[str, str], expected: str) -> None:
    assert level(told, "launch config", "other") == expected

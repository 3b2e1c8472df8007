"""A folder that a launch file makes in the share directory, and fills there itself (SET206, CMK101)."""

from __future__ import annotations

import pytest

from rospkg_cli.example import BACKDROPS, CMAKE, existing_files, manifest, setup_py
from rospkg_cli.testing import lint_files

ENTRY = "        ('share/' + package_name, ['package.xml']),\n"
LAUNCH_FILES = "        ('share/' + package_name + '/launch', glob('launch/*')),\n"
PYTHON = {
    **existing_files(BACKDROPS["ament_python"]),
    "setup.py": "from glob import glob\n" + setup_py().replace(ENTRY, ENTRY + LAUNCH_FILES),
}
NATIVE = {
    "package.xml": manifest("  <exec_depend>ros2launch</exec_depend>\n", "ament_cmake"),
    "CMakeLists.txt": CMAKE.replace(
        "ament_package", "install(DIRECTORY launch DESTINATION share/${PROJECT_NAME})\nament_package"
    ),
}
WORLD = {"worlds/hall.sdf": "<sdf/>\n"}
START = """\
import os
import subprocess
from pathlib import Path

from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch.actions import ExecuteProcess, OpaqueFunction
from launch_ros.substitutions import FindPackageShare


def start(context):
{}
    return [ExecuteProcess(cmd=['gz', 'sim', '-r', str(world)])]


def generate_launch_description():
    return LaunchDescription([OpaqueFunction(function=start)])
"""
SHARE = "share = Path(FindPackageShare('my_pkg').perform(context))"
WORLDS, NAMED = "worlds = share / 'worlds'", "world = worlds / 'hall.sdf'"
MAKE = "worlds.mkdir(parents=True, exist_ok=True)"
RUN = "make = ExecuteProcess(cmd=['python3', str(share / 'make.py'), '--out', str(world)])"
JOINED = (
    "share = get_package_share_directory('my_pkg')",
    "worlds = os.path.join(share, 'worlds')",
    "world = os.path.join(worlds, 'hall.sdf')",
)


def levels(on: dict[str, str], *lines: str) -> list[str]:
    text = START.format("\n".join(f"    {line}" for line in lines))
    found = lint_files({**on, **WORLD, "launch/a.launch.py": text}, ["SET206", "CMK101"]).findings
    return [each.severity.value for each in found]


@pytest.mark.parametrize("on", [PYTHON, NATIVE])
@pytest.mark.parametrize(
    "lines",
    [
        (SHARE, WORLDS, MAKE, NAMED, RUN),
        (SHARE, WORLDS, MAKE, NAMED, RUN.replace("'--out', str(world)", "f'--output={world}'")),
        (SHARE, WORLDS, MAKE, NAMED, "world.write_text(sdf())"),
        (*JOINED, "os.makedirs(worlds, exist_ok=True)", "open(world, 'w').write(sdf())"),
        (*JOINED, "os.makedirs(os.path.dirname(world), exist_ok=True)", "open(world, 'w').write(sdf())"),
        (*JOINED, "os.makedirs(name=worlds)", "subprocess.run(['xacro', 'a.xacro', '-o', world])"),
        ("name = 'my_pkg'", JOINED[0].replace("'my_pkg'", "name"), *JOINED[1:], "os.mkdir(worlds)",
         "os.system(f'xacro a.xacro > {world}')"),
    ],
)  # fmt: skip
def test_a_folder_that_is_made_and_filled(on: dict[str, str], lines: tuple[str, ...]) -> None:
    assert levels(on, *lines) == []


@pytest.mark.parametrize("on", [PYTHON, NATIVE])
@pytest.mark.parametrize(
    "lines",
    [
        (SHARE, WORLDS, NAMED),
        (SHARE, WORLDS, MAKE, NAMED),
        (SHARE, WORLDS, NAMED, RUN),
        (SHARE, WORLDS, MAKE, NAMED, RUN.replace("world)", "other)")),
        (SHARE, WORLDS, MAKE, NAMED, "(worlds / 'other.sdf').write_text(sdf())"),
        (*JOINED, "os.makedirs(os.path.join('/tmp', 'worlds'))", "open(world, 'w').write(sdf())"),
    ],
)
def test_a_folder_that_is_not_filled(on: dict[str, str], lines: tuple[str, ...]) -> None:
    assert levels(on, *lines) == ["error"]

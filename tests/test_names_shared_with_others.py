"""An entry point that can't start, whose name is also that of another package or of its program (SET101)."""

from __future__ import annotations

import pytest

from rospkg_cli.example import BACKDROPS, existing_files, manifest, scripts, setup_py
from rospkg_cli.testing import lint_files

NODE = "def main():\n    print('hello')\n"
RUN = """\
from launch import LaunchDescription
from launch.actions import ExecuteProcess


def generate_launch_description():
    return LaunchDescription([ExecuteProcess(cmd=['ros2', 'run', 'my_pkg', '{}'])])
"""
BASE = existing_files(BACKDROPS["ament_python"])
OWN = {
    **{f"src/my_pkg/{path}": text for path, text in BASE.items()},
    "src/my_pkg/package.xml": manifest(),
    "src/my_pkg/setup.py": setup_py(scripts("talker = my_pkg.talker:main", "lidar = my_pkg.lidar:main")),
    "src/my_pkg/my_pkg/talker.py": NODE,
    "src/user/package.xml": manifest("", "ament_cmake", "user"),
    "src/user/launch/all.launch.py": RUN.format("talker"),
}
OTHER = {"src/lidar/package.xml": manifest("", "ament_python", "lidar")}
PROGRAM = {
    "src/drivers/package.xml": manifest("", "ament_python", "drivers"),
    "src/drivers/setup.py": setup_py(scripts("lidar = drivers.lidar:main")).replace("my_pkg", "drivers"),
    "src/drivers/setup.cfg": BASE["setup.cfg"].replace("my_pkg", "drivers"),
    "src/drivers/drivers/__init__.py": "",
    "src/drivers/drivers/lidar.py": NODE,
}
PAGE = {"README.md": "The node `lidar` reads the lidar.\n"}


@pytest.mark.parametrize(
    ("more", "level"),
    [
        ({}, "warning"),
        (PAGE, "error"),
        ({**PAGE, **OTHER}, "warning"),
        ({**PAGE, **PROGRAM}, "warning"),
        ({"README.md": "It publishes /lidar, and build/lidar is left.\n"}, "warning"),
        ({**OTHER, "README.md": "    ros2 run my_pkg lidar\n"}, "error"),
        ({**OTHER, "src/user/launch/all.launch.py": RUN.format("lidar")}, "error"),
        ({"src/user/launch/all.launch.py": RUN.format("lidar")}, "error"),
        ({"start.sh": "install/my_pkg/lib/my_pkg/lidar &\n"}, "error"),
        ({"src/user/launch/all.launch.py": "", ".github/workflows/a.yml": "run: ros2 run my_pkg talker\n"}, "warning"),
        ({"src/user/launch/all.launch.py": "", "README.md": "    ros2 run my_pkg talker\n"}, "warning"),
        ({"src/user/launch/all.launch.py": ""}, "error"),
    ],
)  # fmt: skip
def test_an_entry_point_called_as_something_else(more: dict[str, str], level: str) -> None:
    (found,) = lint_files({**OWN, **more}, ["SET101"]).findings
    assert found.severity.value == level

"""A launch description among the modules of a package, which only its path starts (DEP103, LCH002)."""

from __future__ import annotations

import pytest

from rospkg_cli.example import manifest
from rospkg_cli.testing import lint_files

SETUP = """\
from setuptools import setup

setup(
    name='my_pkg', version='0.1.0', packages=['my_pkg'], data_files=[('share/my_pkg', ['package.xml'])],
    entry_points={'console_scripts': ['talker = my_pkg.talker:main']},
)
"""
VIEW = """\
from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription([Node(package='joy', executable='joy_node')])
"""
INCLUDING = VIEW.replace("Node(package='joy', executable='joy_node')", "IncludeLaunchDescription('my_pkg/view.py')")
TALKER = "def main():\n    pass\n"


def level(**more: str) -> str | None:
    files = {
        "package.xml": manifest("  <exec_depend>ros2launch</exec_depend>\n"),
        "setup.py": SETUP,
        "my_pkg/__init__.py": "",
        "my_pkg/talker.py": TALKER,
        "my_pkg/view.py": VIEW,
    }
    files |= {path.replace("__", "/").replace("_dot_", "."): text for path, text in more.items()}
    found = [each for each in lint_files(files, ["DEP103"]).findings if "joy" in each.message]
    return found[0].severity.value if found else None


@pytest.mark.parametrize(
    ("more", "expected"),
    [
        ({}, "info"),
        ({"tools_dot_sh": "chmod +x src/my_pkg/my_pkg/view.py\n"}, "info"),
        ({"tools_dot_sh": "chmod +x src/my_pkg/my_pkg/view.py\nros2 launch src/my_pkg/my_pkg/view.py\n"}, "warning"),
        ({"README_dot_md": "`ros2 launch my_pkg/view.py`\n"}, "warning"),
        ({"my_pkg__talker_dot_py": f"from my_pkg.view import generate_launch_description\n\n\n{TALKER}"}, "warning"),
        ({"my_pkg__talker_dot_py": f"from . import view\n\n\n{TALKER}"}, "warning"),
        ({"launch__a_dot_launch_dot_py": INCLUDING}, "warning"),
        ({"my_pkg__view_dot_py": f"{VIEW}\n\nif __name__ == '__main__':\n    start()\n",
          "tools_dot_sh": "chmod +x my_pkg/view.py\n"}, "warning"),
    ],
)  # fmt: skip
def test_who_starts_it_by_its_path_or_takes_it(more: dict[str, str], expected: str) -> None:
    assert level(**more) == expected

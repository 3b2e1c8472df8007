"""A missing file on the command line of a node that reads none is an info (LCH003)."""

from __future__ import annotations

import pytest

from rospkg_cli.example import manifest
from rospkg_cli.testing import lint_files

SETUP = """\
from setuptools import setup

setup(
    name='my_pkg', version='0.1.0', packages=['my_pkg'],
    data_files=[('share/my_pkg', ['package.xml', 'launch/a.launch.py'])],
    entry_points={'console_scripts': ['talker = my_pkg.talker:main']},
)
"""
LAUNCH = """\
from launch import LaunchDescription
from launch.substitutions import PathJoinSubstitution
from launch_ros.actions import Node
from launch_ros.substitutions import FindPackageShare


def generate_launch_description():
    path = PathJoinSubstitution([FindPackageShare('my_pkg'), 'data', 'a.dat'])
    return LaunchDescription([{nodes}])
"""
NODE = "Node(package='my_pkg', executable='talker', arguments=[{}])"
PLAIN = "import sys\n\nimport rclpy\n\n\ndef main(args=None):\n    rclpy.init(args=args)\n"


@pytest.mark.parametrize(
    ("nodes", "code", "level"),
    [
        (NODE.format("path"), PLAIN, "info"),
        (NODE.format("path"), PLAIN.replace("args=args", "args=sys.argv"), "info"),
        (NODE.format("'fast', path"), PLAIN, "info"),
        (NODE.format("path"), f"{PLAIN}    # sys.argv\n", "info"),
        (NODE.format("path"), f"{PLAIN}    open(sys.argv[1])\n", "warning"),
        (NODE.format("path"), f"{PLAIN}    work(args)\n", "warning"),
        (NODE.format("path"), f"import argparse\n{PLAIN}", "warning"),
        (NODE.format("path"), f"from my_pkg.options import *\n{PLAIN}", "warning"),
        (NODE.format("'--ros-args', '--params-file', path"), PLAIN, "warning"),
        (f"{NODE.format('path')}, {NODE.format('path').replace('my_pkg', 'other')}", PLAIN, "warning"),
        (NODE.format("path").replace("talker", "listener"), PLAIN, "warning"),
    ],
)
def test_a_program_that_reads_no_argument_opens_no_file_of_it(nodes: str, code: str, level: str) -> None:
    files = {"package.xml": manifest(), "setup.py": SETUP, "my_pkg/__init__.py": "", "my_pkg/talker.py": code}
    files["launch/a.launch.py"] = LAUNCH.format(nodes=nodes)
    (finding,) = lint_files(files, ["LCH003"]).findings
    assert finding.severity.value == level
    assert ("but `talker` reads no argument" in finding.message) is (level == "info")

"""A syntax error is told by default, whatever stands in its line, in each kind of file that colcon or launch runs."""

from __future__ import annotations

import pytest

from rospkg_cli.example import BACKDROPS, SETUP_PY
from rospkg_cli.testing import lint_files

LAUNCH = "from launch import LaunchDescription\n\n\ndef generate_launch_description():\n    {}\n"
BROKEN = {
    "setup.py": SETUP_PY.replace("'share/' + package_name, ['package.xml']", "f'share/{package_name}', ['package.xml'"),
    "launch/robot.launch.py": LAUNCH.format("return LaunchDescription(]"),
    "my_pkg/talker.py": "def main():\n    while True:\n        break]\n",
    "my_pkg/listener.py": "def main():\n    for each in (1, 2):\n        continue f'{each}'\n",
}


@pytest.mark.parametrize("path", BROKEN)
def test_a_syntax_error_is_told(path: str) -> None:
    files = {**BACKDROPS["ament_python"], path: BROKEN[path]}
    found = [each for each in lint_files(files, None).findings if each.code == "RPK001"]
    assert [each.location.path for each in found] == [path]
    assert found[0].severity.value == "error"

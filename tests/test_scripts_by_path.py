"""Scripts that pages and scripts give to Python by their paths: where they are installed matters to nobody."""

from __future__ import annotations

import pytest

from rospkg_cli.example import CMAKE, manifest
from rospkg_cli.testing import lint_files

SCRIPT = "#!/usr/bin/env python3\nimport rclpy\nfrom words import GREETING\n\nrclpy.init()\nprint(GREETING)\n"
BY_PATH = "Start it with `python3 scripts/talker.py`.\n"
BY_NAME = "Start it with `ros2 run my_pkg talker.py`.\n"


def told(code: str, rule: str, texts: dict[str, str]) -> list[str]:
    files = {
        "package.xml": manifest("  <exec_depend>rclpy</exec_depend>\n", "ament_cmake"),
        "CMakeLists.txt": CMAKE.replace("ament_package", f"{rule}\nament_package"),
        "scripts/talker.py": SCRIPT,
        "scripts/words.py": "GREETING = 'hello'\n",
    }
    found = lint_files({f"src/my_pkg/{path}": text for path, text in files.items()} | texts, [code]).findings
    return [each.severity.value for each in found]


@pytest.mark.parametrize(
    ("texts", "level"),
    [
        ({}, "warning"),
        ({"README.md": BY_PATH}, "info"),
        ({"talk.sh": "python3 src/my_pkg/scripts/talker.py\n"}, "info"),
        ({"README.md": BY_PATH + BY_NAME}, "warning"),
        ({"README.md": "`python3 install/my_pkg/lib/my_pkg/talker.py`\n"}, "warning"),
    ],
)
def test_modules_beside_a_script(texts: dict[str, str], level: str) -> None:
    assert told("CMK109", "install(PROGRAMS scripts/talker.py DESTINATION lib/${PROJECT_NAME})", texts) == [level]


@pytest.mark.parametrize(
    ("texts", "levels"),
    [
        ({}, ["warning"]),
        ({"talk.sh": "python3 $(ros2 pkg prefix my_pkg)/share/my_pkg/scripts/talker.py\n"}, []),
        ({"README.md": BY_PATH}, []),
        ({"README.md": BY_PATH, "talk.sh": "ros2 run my_pkg talker.py\n"}, ["warning"]),
    ],
)
def test_where_a_script_is_installed(texts: dict[str, str], levels: list[str]) -> None:
    rule = "install(PROGRAMS scripts/talker.py DESTINATION share/${PROJECT_NAME}/scripts)"
    assert told("CMK104", rule, texts) == levels

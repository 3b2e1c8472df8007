"""IDL010, IDL011: fields and messages that a comment or a page has people write."""

from __future__ import annotations

import pytest

from rospkg_cli.example import SETUP_CFG, SETUP_PY_FOR_ALL, manifest
from rospkg_cli.testing import lint_files

CMAKE = """\
cmake_minimum_required(VERSION 3.8)
project(my_msgs)
find_package(ament_cmake REQUIRED)
find_package(rosidl_default_generators REQUIRED)
rosidl_generate_interfaces(${PROJECT_NAME} msg/Battery.msg)
ament_package()
"""
FIELD = "from my_msgs.msg import Battery\n\n\ndef main():\n    Battery().voltage = 1.0\n"
MESSAGE = "from my_msgs.msg import Lamp\n\n\ndef main():\n    print(Lamp())\n"


def level(code: str, text: str, page: str = "", fields: str = "") -> str:
    programs = "    entry_points={'console_scripts': ['talker = my_pkg.talker:main']},\n"
    files = {
        "README.md": page,
        "my_msgs/package.xml": manifest("", "ament_cmake", "my_msgs"),
        "my_msgs/CMakeLists.txt": CMAKE,
        "my_msgs/msg/Battery.msg": f"{fields}float32 level\n",
        "my_pkg/package.xml": manifest("  <exec_depend>my_msgs</exec_depend>\n"),
        "my_pkg/setup.py": SETUP_PY_FOR_ALL.replace("    license=", f"{programs}    license="),
        "my_pkg/setup.cfg": SETUP_CFG,
        "my_pkg/resource/my_pkg": "",
        "my_pkg/my_pkg/__init__.py": "",
        "my_pkg/my_pkg/talker.py": text,
    }
    (only,) = lint_files(files, [code]).findings
    return only.severity.value


@pytest.mark.parametrize(
    ("comment", "page", "fields", "expected"),
    [
        ("", "", "", "error"),
        ("# TODO: add voltage to Battery.msg\n", "", "", "info"),
        ("", "", "# TODO: add the voltage\n", "info"),
        ("", "Exercise: add the field `voltage` to `Battery.msg`.\n", "", "info"),
        ("# TODO: add a test\n", "", "", "error"),
        ("", "", "# the voltage is left out\n", "error"),
        ("", "Add the field `level` to the plot, and `voltage`-like values.\n", "", "error"),
    ],
)
def test_a_field(comment: str, page: str, fields: str, expected: str) -> None:
    assert level("IDL010", comment + FIELD, page, fields) == expected


@pytest.mark.parametrize(
    ("comment", "page", "expected"),
    [
        ("", "", "error"),
        ("# TODO: create Lamp.msg\n", "", "info"),
        ("", "Create `msg/Lamp.msg` with a field `on`.\n", "info"),
        ("# uses Lamp.msg\n", "", "error"),
        ("", "`Lamp.msg` says whether the lamp is on.\n", "error"),
    ],
)
def test_a_message(comment: str, page: str, expected: str) -> None:
    assert level("IDL011", comment + MESSAGE, page) == expected

"""IDL008: how many meet the import of an interface that nothing generates."""

from __future__ import annotations

import pytest

from rospkg_cli.example import SETUP_CFG, SETUP_PY_FOR_ALL, manifest
from rospkg_cli.testing import lint_files

TAKES = "from my_pkg.msg import Battery\n"
USES = "def main():\n    print(Battery())\n"
INSIDE = "def main():\n    pass\n\n\ndef {}():\n    from my_pkg.msg import Battery\n\n    print(Battery())\n"


def level(text: str = TAKES + USES, programs: str = "'talker = my_pkg.talker:main'", **others: str) -> str:
    entries = f"    entry_points={{'console_scripts': [{programs}]}},\n"
    files = {
        "package.xml": manifest("  <exec_depend>rclpy</exec_depend>\n"),
        "setup.py": SETUP_PY_FOR_ALL.replace("    license=", f"{entries}    license="),
        "setup.cfg": SETUP_CFG,
        "resource/my_pkg": "",
        "my_pkg/__init__.py": "",
        "my_pkg/talker.py": text,
        "msg/Battery.msg": "float32 level\n",
        **others,
    }
    (only,) = lint_files(files, ["IDL008"]).findings
    return only.severity.value


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        (TAKES + USES, "error"),
        ("import my_pkg.msg\n\n\ndef main():\n    print(my_pkg.msg.Battery())\n", "error"),
        ("from my_pkg import msg\n\n\ndef main():\n    print(msg.Battery())\n", "error"),
        (f"try:\n    {TAKES}except ImportError:\n    Battery = None\n\n\n{USES}", "info"),
        (f"from typing import TYPE_CHECKING\n\nif TYPE_CHECKING:\n    {TAKES}\n\n{USES}", "info"),
        (f"ON = False\n\nif ON:\n    {TAKES}\n\n{USES}", "info"),
        (INSIDE.format("show"), "info"),
        (INSIDE.format("show").replace("pass", "show()"), "warning"),
    ],
)
def test_where_the_import_stands(text: str, expected: str) -> None:
    assert level(text) == expected


def test_a_program_that_nothing_starts() -> None:
    both = "'talker = my_pkg.talker:main', 'other = my_pkg.other:main'"
    other = {"my_pkg/other.py": "def main():\n    pass\n"}
    launch = '<launch><node pkg="my_pkg" exec="{}"/></launch>\n'
    assert level(programs=both, **other, **{"launch/a.launch.xml": launch.format("other")}) == "warning"
    assert level(programs=both, **other, **{"launch/a.launch.xml": launch.format("talker")}) == "error"


@pytest.mark.parametrize(
    ("path", "text", "expected"),
    [
        ("my_pkg/msg.py", "class Battery:\n    pass\n", "info"),
        ("my_pkg/msg/__init__.py", "class Battery:\n    pass\n", "info"),
        ("Makefile", "code:\n\trosidl generate -o my_pkg -t py my_pkg msg/Battery.msg\n", "info"),
        ("README.md", "    ros2 interface show my_pkg/msg/Battery\n", "error"),
        ("my_pkg/message.py", "", "error"),
    ],
)
def test_a_module_of_that_name(path: str, text: str, expected: str) -> None:
    assert level(**{path: text}) == expected

"""DEP118: who meets a path in one person's home, and who has it replaced or never comes to it."""

from __future__ import annotations

import pytest

from rospkg_cli.example import BACKDROPS, SETUP_PY_FOR_ALL, existing_files, scripts, setup_py
from rospkg_cli.testing import lint_files

PACKAGE = {**existing_files(BACKDROPS["ament_python"]), "data/a.txt": "Ada\n"}
PLACE = "/home/ada/ws/src/my_pkg/data/a.txt"
PROGRAMS = setup_py(scripts("talker = my_pkg.talker:main", "trainer = my_pkg.trainer:main"))
TRAINER = f"def main():\n    a = open('{PLACE}')\n    return a\n"
TALKER = "def main():\n    pass\n"
ARGUMENT = f"""\
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument


def generate_launch_description():
    return LaunchDescription([DeclareLaunchArgument('model', default_value='{PLACE}')])
"""
XML = f'<launch>\n  <arg name="model" default="{PLACE}"/>\n</launch>\n'
CALLER = '<launch>\n  <include file="$(find-pkg-share my_pkg)/launch/{}">\n{}  </include>\n</launch>\n'
GIVES = '    <arg name="model" value="$(env MODEL)"/>\n'
RUNS = "Run `ros2 launch my_pkg {}`.\n"


def level(files: dict[str, str]) -> str:
    (found,) = lint_files({**PACKAGE, **files}, ["DEP118"]).findings
    return found.severity.value


@pytest.mark.parametrize(
    ("page", "expected"),
    [
        ("Run `ros2 run my_pkg talker`.\n", "info"),
        ("Run `ros2 run my_pkg trainer`.\n", "warning"),
        ("", "warning"),  # nothing shows how programs are started here
    ],
)
def test_a_program_that_nothing_starts_beside_others(page: str, expected: str) -> None:
    code = {"my_pkg/talker.py": TALKER, "my_pkg/trainer.py": TRAINER}
    assert level({**code, "setup.py": PROGRAMS, "README.md": page}) == expected


def test_what_goes_on_without_the_file() -> None:
    opens = f"    a = open('{PLACE}')\n"
    start = setup_py(scripts("talker = my_pkg.talker:main"))
    guarded = f"    try:\n    {opens}    except OSError:\n        a = None\n    print(a)\n"
    assert level({"setup.py": start, "my_pkg/talker.py": f"def main():\n{guarded}"}) == "info"
    assert level({"setup.py": start, "my_pkg/talker.py": f"def main():\n{opens}    print(a)\n"}) == "warning"


@pytest.mark.parametrize(("name", "text"), [("a.launch.py", ARGUMENT), ("a.launch.xml", XML)])
def test_an_argument_that_all_callers_give(name: str, text: str) -> None:
    own = {"setup.py": SETUP_PY_FOR_ALL, f"launch/{name}": text}
    gives, leaves = CALLER.format(name, GIVES), CALLER.format(name, "")
    assert level(own) == "warning"
    assert level({**own, "launch/b.launch.xml": gives}) == "info"
    assert level({**own, "launch/b.launch.xml": leaves}) == "warning"
    assert level({**own, "launch/b.launch.xml": gives, "README.md": RUNS.format(name)}) == "warning"
    assert level({**own, "README.md": RUNS.format(f"{name} model:=b.pt")}) == "info"


def test_a_twin_in_another_language() -> None:
    own = {"setup.py": SETUP_PY_FOR_ALL, "launch/a.launch.xml": XML, "launch/a.launch.py": "A = 1\n"}
    assert level(own) == "warning"
    assert level({**own, "README.md": RUNS.format("a.launch.py")}) == "info"
    assert level({**own, "README.md": RUNS.format("a.launch.xml")}) == "warning"

"""A program that nothing starts, beside others that are started, is an offer: what ends it is a warning."""

from __future__ import annotations

import pytest

from rospkg_cli.example import BACKDROPS, existing_files, scripts, setup_py
from rospkg_cli.testing import lint_files

START = '<launch>\n  <node pkg="my_pkg" exec="{}"/>\n</launch>\n'
PROGRAM = "from my_pkg.words import say\n\n\ndef main():\n    json.loads('{}')\n    say()\n"
PYTHON = {
    **existing_files(BACKDROPS["ament_python"]),
    "setup.py": setup_py(scripts("talker = my_pkg.talker:main", "ears = my_pkg.ears:main")),
    "my_pkg/talker.py": PROGRAM,
    "my_pkg/ears.py": PROGRAM.replace("json.loads", "print"),
    "my_pkg/words.py": "def say():\n    pass\n",
}


def level(files: dict[str, str], code: str = "DEP117") -> str:
    (found,) = lint_files({**PYTHON, **files}, [code]).findings
    return found.severity.value


@pytest.mark.parametrize(
    ("files", "expected"),
    [
        ({}, "error"),
        ({"launch/a.launch.xml": START.format("ears")}, "warning"),
        ({"launch/a.launch.xml": START.format("talker")}, "error"),
        ({"README.md": "Type `ros2 run my_pkg ears`.\n"}, "warning"),
        ({"README.md": "Type `ros2 run my_pkg ears`, or `talker`.\n"}, "error"),
        ({"README.md": "ros2 run my_pkg ears\n", "scripts/a.sh": "ros2 run my_pkg talker\n"}, "error"),
        (
            {
                "README.md": "ros2 run my_pkg ears\n",
                "my_pkg/ears.py": "import os\nos.system('ros2 run my_pkg talker')\n",
            },
            "error",
        ),
        (
            {"launch/a.launch.xml": START.format("ears"), "systemd/a.service": "ExecStart=ros2 run my_pkg talker\n"},
            "error",
        ),
    ],
)
def test_a_program_that_nothing_starts(files: dict[str, str], expected: str) -> None:
    assert level(files) == expected


@pytest.mark.parametrize(("started", "expected"), [("ears", "error"), ("other", "warning")])
def test_a_module_of_several_programs(started: str, expected: str) -> None:
    names = ("talker = my_pkg.talker:main", "ears = my_pkg.ears:main", "other = my_pkg.other:main")
    files = {
        "setup.py": setup_py(scripts(*names)),
        "my_pkg/talker.py": PROGRAM.replace("json.loads", "print"),
        "my_pkg/other.py": "def main():\n    pass\n",
        "my_pkg/words.py": "import my_pkg.gone\n\n\ndef say():\n    pass\n",
        "launch/a.launch.xml": START.format(started),
    }
    assert level(files, "DEP109") == expected


def test_a_launch_file_of_another_package() -> None:
    files = {f"a/{path}": text for path, text in {**PYTHON, "launch/a.launch.xml": START.format("ears")}.items()}
    files |= {
        "b/package.xml": PYTHON["package.xml"].replace("my_pkg", "b"),
        "b/launch/b.launch.xml": START.format("talker"),
    }
    (found,) = lint_files(files, ["DEP117"]).findings
    assert found.severity.value == "error"


def test_what_only_some_runs_of_it_meet_stays_a_warning() -> None:
    seldom = PROGRAM.replace("    json", "    if say():\n        json")
    assert level({"my_pkg/talker.py": seldom}) == "warning"
    assert level({"my_pkg/talker.py": seldom, "launch/a.launch.xml": START.format("ears")}) == "warning"

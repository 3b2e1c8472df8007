"""Modules that no build installs, and that nobody misses: the source is on the path, or nothing needs them."""

from __future__ import annotations

import pytest

from rospkg_cli.example import BACKDROPS, existing_files, scripts, setup_py
from rospkg_cli.testing import lint_files

LISTED = "find_packages(exclude=['test'])"
NEEDS = "from my_pkg.speech.words import HELLO\n"
MAIN = "\n\ndef main():\n    pass\n"
INIT = {"my_pkg/speech/__init__.py": ""}
TRIED = "try:\n    from my_pkg.speech.words import HELLO\nexcept ImportError:\n    {}\n"
LAUNCH = """\
from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription([Node(package='my_pkg', executable='listener')])
"""


def level(head: str, outside: dict[str, str] | None = None, more: dict[str, str] | None = None, *, listed: bool) -> str:
    entries = scripts("talker = my_pkg.talker:main", "listener = my_pkg.listener:main")
    setup = setup_py(entries)
    files = {
        **existing_files(BACKDROPS["ament_python"]),
        "setup.py": setup.replace(LISTED, "['my_pkg']") if listed else setup,
        "my_pkg/talker.py": head + MAIN,
        "my_pkg/listener.py": MAIN.lstrip(),
        "my_pkg/speech/words.py": "HELLO = 'hello'\n",
        **(INIT if listed else {}),
        **(more or {}),
    }
    placed = {f"src/my_pkg/{path}": text for path, text in files.items()}
    found = lint_files({**placed, **(outside or {})}, ["SET301", "SET302"]).findings
    assert [each.code for each in found] == ["SET302" if listed else "SET301"]
    return found[0].severity.value


@pytest.mark.parametrize("listed", [False, True])
@pytest.mark.parametrize(
    ("outside", "expected"),
    [
        ({"Dockerfile": "FROM ros:jazzy\nENV PYTHONPATH=/ws/src/my_pkg:$PYTHONPATH\n"}, "info"),
        ({"Dockerfile": "FROM ros:jazzy\nENV PYTHONPATH=/ws/src/other:$PYTHONPATH\n"}, "error"),
        ({"README.md": "Then `export PYTHONPATH=$PWD/src/my_pkg`.\n"}, "info"),
        ({"README.md": "Then `cd src/my_pkg && pip install -e .`.\n"}, "info"),
        ({"README.md": "Then `pip install --editable src/my_pkg`.\n"}, "info"),
        ({"README.md": "Then `pip install src/my_pkg`.\n"}, "error"),
        ({"README.md": "Then `pip install -e src/other`.\n"}, "error"),
        ({"src/my_pkg/README.md": "`pip3 install -e .`\n"}, "info"),
    ],
)
def test_the_source_folder_is_on_the_path(outside: dict[str, str], expected: str, listed: bool) -> None:
    assert level(NEEDS, outside, listed=listed) == expected


@pytest.mark.parametrize("listed", [False, True])
@pytest.mark.parametrize(
    ("head", "expected"),
    [
        (TRIED.format("HELLO = 'hi'"), "info"),
        (TRIED.format("HELLO = None"), "info"),
        (TRIED.format("pass"), "warning"),
        (TRIED.format("from speech.words import HELLO"), "warning"),
        (TRIED.format("HELLO = ''\n    raise"), "warning"),
        (TRIED.format("HELLO = ''\n    exit(1)"), "warning"),
        (f"import rospy\n{NEEDS}", "info"),
        (f"{NEEDS}import rospy\n", "error"),
    ],
)
def test_what_an_import_comes_to(head: str, expected: str, listed: bool) -> None:
    assert level(head, listed=listed) == expected


@pytest.mark.parametrize("listed", [False, True])
@pytest.mark.parametrize(
    ("launch", "expected"),
    [(LAUNCH, "warning"), (LAUNCH.replace("listener", "talker"), "error"), ("", "error")],
)
def test_who_starts_the_program(launch: str, expected: str, listed: bool) -> None:
    assert level(NEEDS, more={"launch/a.launch.py": launch} if launch else {}, listed=listed) == expected

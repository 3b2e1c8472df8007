"""Modules of entry points that are still to be written, or that a text fetches; and what Python finds in the source."""

from __future__ import annotations

import pytest

from rospkg_cli.example import BACKDROPS, CMAKE, existing_files, scripts, setup_py
from rospkg_cli.testing import lint_files

ENTRY = "'listener = my_pkg.listener:main'"
OWN = {**existing_files(BACKDROPS["ament_python"]), "my_pkg/talker.py": "def main():\n    pass\n"}


def level(above: str = "", told: dict[str, str] | None = None) -> str:
    listed = setup_py(scripts("listener = my_pkg.listener:main"))
    comment = f"\n            {above}\n            " if above else ""
    files = {**OWN, "setup.py": listed.replace(ENTRY, f"{comment}{ENTRY}"), **(told or {})}
    (found,) = lint_files(files, ["SET101"]).findings
    return found.severity.value


@pytest.mark.parametrize(
    ("above", "expected"),
    [
        ("# not implemented yet", "info"),
        ("# the listener isn't ported yet", "info"),
        ("# coming soon", "info"),
        ("# still to be written", "info"),
        ("# listens to the talker", "error"),
        ("# not needed on the robot", "error"),
    ],
)
def test_what_a_comment_above_says(above: str, expected: str) -> None:
    assert level(above) == expected


@pytest.mark.parametrize(
    ("told", "expected"),
    [
        ({"Makefile": "gen:\n\tpython3 tools/gen.py > my_pkg/listener.py\n"}, "info"),
        ({"build.sh": "curl -o my_pkg/listener.py https://example.org/a.py\n"}, "info"),
        ({"build.sh": "python3 my_pkg/listener.py\n"}, "error"),
        ({"build.sh": "curl -o my_pkg/other.py https://example.org/a.py\n"}, "error"),
    ],
)
def test_who_makes_the_module(told: dict[str, str], expected: str) -> None:
    assert level(told=told) == expected


RULE = "install(PROGRAMS scripts/node.py DESTINATION lib/${PROJECT_NAME})\nament_package"
OF_CMAKE = {
    **existing_files(BACKDROPS["ament_cmake"]),
    "CMakeLists.txt": CMAKE.replace("ament_package", RULE),
    "my_pkg/__init__.py": "",
    "my_pkg/helper.py": "RATE = 10.0\n",
    "scripts/other.py": "RATE = 10.0\n",
}
START = "#!/usr/bin/env python3\n"


@pytest.mark.parametrize(
    ("needs", "text", "expected"),
    [
        ("from my_pkg.helper import RATE", "ENV PYTHONPATH=/ws/src/my_pkg", "info"),
        ("from my_pkg.helper import RATE", "ENV PYTHONPATH=/ws/src/my_pkg/scripts", "error"),
        ("from my_pkg.helper import RATE", "RUN pip install -e src/my_pkg", "info"),
        ("from my_pkg.helper import RATE", "RUN pip install src/my_pkg", "error"),
        ("from other import RATE", "ENV PYTHONPATH=/ws/src/my_pkg/scripts", "info"),
        ("from other import RATE", "ENV PYTHONPATH=/ws/src/my_pkg", "warning"),
        ("from other import RATE", "RUN pip install -e src/my_pkg", "warning"),
    ],
)
def test_what_a_script_of_cmake_finds(needs: str, text: str, expected: str) -> None:
    files = {
        **OF_CMAKE,
        "scripts/node.py": f"{START}{needs}\n\nprint(RATE)\n",
        "setup.py": "from setuptools import setup\n",
    }
    placed = {f"src/my_pkg/{path}": content for path, content in files.items()}
    (found,) = lint_files({**placed, "Dockerfile": f"FROM ros:jazzy\n{text}\n"}, ["CMK109"]).findings
    assert found.severity.value == expected

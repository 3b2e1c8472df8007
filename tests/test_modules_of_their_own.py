"""Modules below a listed package that `py_modules` installs one by one (SET301, SET302)."""

from __future__ import annotations

import pytest

from rospkg_cli.example import BACKDROPS, existing_files, scripts, setup_py
from rospkg_cli.testing import lint_files

FOUND = "packages=find_packages(exclude=['test'])"
TALKER = "from .speech.words import A\n\n\ndef main():\n    print(A)\n"
SETUP = setup_py(scripts("talker = my_pkg.talker:main"))


@pytest.mark.parametrize(
    ("modules", "first", "more", "expected"),
    [
        ("", "", {"__init__": ""}, ["SET302"]),
        ("'my_pkg.speech.words'", "", {"__init__": ""}, []),
        ("'my_pkg.speech.words'", "", {"__init__": "", "others": "B = 1\n"}, []),
        ("'my_pkg.speech.words'", "from .speech.others import B\n", {"__init__": "", "others": "B = 1\n"}, ["SET302"]),
        ("'my_pkg.speech.others'", "", {"__init__": "", "others": "B = 1\n"}, ["SET302"]),
        ("'my_pkg.speech.words'", "", {}, []),
        ("", "", {}, ["SET301"]),
        ("'my_pkg.speech.words'", "from .speech.deep.c import C\n",
         {"__init__": "", "deep/__init__": "", "deep/c": "C = 1\n"}, ["SET302"]),
    ],
)  # fmt: skip
def test_modules_with_dots_in_py_modules(modules: str, first: str, more: dict[str, str], expected: list[str]) -> None:
    files = {
        **existing_files(BACKDROPS["ament_python"]),
        "setup.py": SETUP.replace(FOUND, f"packages=['my_pkg'], py_modules=[{modules}]"),
        "my_pkg/talker.py": first + TALKER,
        "my_pkg/speech/words.py": "A = 1\n",
        **{f"my_pkg/speech/{name}.py": text for name, text in more.items()},
    }
    assert [each.code for each in lint_files(files, ["SET301", "SET302"]).findings] == expected

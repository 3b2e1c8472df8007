"""Modules in lib/<package> are top-level ones for its programs: the first place where Python looks (DEP109, DEP110)."""

from __future__ import annotations

from collections.abc import Mapping

import pytest

from rospkg_cli.example import BACKDROPS, SETUP_PY_FOR_ALL, existing_files
from rospkg_cli.testing import lint_files

ENTRY = "    entry_points={'console_scripts': ['talker = my_pkg.talker:main']},\n    license="
ROW = "    data_files=[\n        ('lib/my_pkg/words', ['my_pkg/words/greeting.py']),"
PACKAGE = {
    **existing_files(BACKDROPS["ament_python"]),
    "my_pkg/words/greeting.py": "HELLO = 'hello'\n",
    "my_pkg/words/parting.py": "BYE = 'bye'\n",
}
EMPTY: Mapping[str, str] = {}
MAIN = "\n\ndef main():\n    print(1)\n"


def found(line: str, row: str = ROW, more: Mapping[str, str] = EMPTY) -> list[str]:
    setup = SETUP_PY_FOR_ALL.replace("    license=", ENTRY)
    assert "    data_files=[" in setup
    setup = setup.replace("    data_files=[", row)
    files = {**PACKAGE, **more, "setup.py": setup, "my_pkg/talker.py": line + MAIN}
    return [f"{each.code} {each.severity.value}" for each in lint_files(files, ["DEP109", "DEP110"]).findings]


@pytest.mark.parametrize(
    "line",
    [
        "from words.greeting import HELLO",
        "import words.greeting",
        "from words import greeting",
    ],
)
def test_a_folder_of_modules_next_to_the_programs_is_found(line: str) -> None:
    assert not found(line)


@pytest.mark.parametrize(
    "line",
    [
        "from words.parting import BYE",
        "import words.parting",
        "from words import parting",
    ],
)
def test_what_that_folder_lacks_is_missing_as_ever(line: str) -> None:
    assert found(line) == ["DEP110 error"]


@pytest.mark.parametrize("folder", ["lib/my_pkg", "lib/other/words", "share/my_pkg/words", "lib/my_pkg/words/inner"])
def test_a_folder_elsewhere_brings_no_module(folder: str) -> None:
    assert found("from words.greeting import HELLO", ROW.replace("lib/my_pkg/words", folder)) == ["DEP110 error"]


def test_a_folder_that_is_called_as_the_package_once_was_is_found() -> None:
    files = {"my_pkg/speech.py": "HELLO = 'hello'\n"}
    row = "    data_files=[\n        ('lib/my_pkg/our_pkg', ['my_pkg/speech.py']),"
    assert not found("from our_pkg.speech import HELLO", row, files)
    assert found("from our_pkg.speech import HELLO", ROW, files) == ["DEP109 info"]


def test_a_single_module_next_to_the_programs_is_found() -> None:
    assert not found("from greeting import HELLO", ROW.replace("lib/my_pkg/words", "lib/my_pkg"))

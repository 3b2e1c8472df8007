"""What `packages` lists with slashes (`my_pkg/modules`) is installed: setuptools takes it for the folder that it is."""

from __future__ import annotations

import pytest

from rospkg_cli.example import BACKDROPS, SETUP_PY, existing_files, scripts, setup_py
from rospkg_cli.rules.setup import set302_package_not_installed as set302
from rospkg_cli.testing import lint_files

PYTHON = existing_files(BACKDROPS["ament_python"])
STARTED = setup_py(scripts("talker = my_pkg.talker:main"))
TALKER = "from my_pkg.speech.words import GREETING\n\n\ndef main():\n    print(GREETING)\n"


def told(packages: str, more: dict[str, str]) -> list[tuple[str, str]]:
    setup = STARTED.replace(set302.FOUND, packages)
    files = {**PYTHON, "setup.py": setup, "my_pkg/talker.py": TALKER, "my_pkg/speech/words.py": "GREETING = 'hello'\n"}
    found = lint_files({**files, **more}, ["SET105", "SET301", "SET302", "DEP109"]).findings
    return [(each.code, each.severity.value) for each in found]


@pytest.mark.parametrize("name", ["'my_pkg/speech'", "package_name + '/speech'", "'my_pkg/speech/'", "'my_pkg.speech'"])
def test_a_listed_folder_without_init_is_installed(name: str) -> None:
    assert told(f"[package_name, {name}]", {}) == [("SET301", "info")]
    assert told(f"[package_name, {name}]", {"my_pkg/speech/__init__.py": ""}) == []


def test_a_folder_that_is_not_listed() -> None:
    assert told("[package_name]", {}) == [("SET301", "error")]
    assert told("['my_pkg/']", {"my_pkg/speech/__init__.py": ""}) == [("SET302", "error")]


def test_the_own_package_with_a_slash() -> None:
    assert SETUP_PY.count(set302.FOUND) == 1
    assert told("['my_pkg/', 'my_pkg/speech/']", {"my_pkg/speech/__init__.py": ""}) == []

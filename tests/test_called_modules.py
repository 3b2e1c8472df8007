"""Modules that setup.py imports and calls (SET308)."""

from __future__ import annotations

import pytest

from rospkg_cli.example import BACKDROPS, SETUP_PY, existing_files
from rospkg_cli.testing import lint_files

ENTRY = "        ('share/' + package_name, ['package.xml']),\n"
BASE = existing_files(BACKDROPS["ament_python"])
LAUNCH = "        ('share/' + package_name + '/launch', {}('launch/*')),\n"


def told(start: str, call: str) -> list[tuple[str, str, bool]]:
    """Return level, name and whether there is a fix."""
    text = f"{start}\n{SETUP_PY.replace(ENTRY, ENTRY + LAUNCH.format(call))}"
    found = lint_files({**BASE, "setup.py": text, "launch/a.launch.xml": "<launch/>\n"}, ["SET308"]).findings
    return [(each.severity.value, each.message.split("`")[1], each.fix is not None) for each in found]


@pytest.mark.parametrize(
    "start, call, expected",
    [
        ("import glob", "glob", [("error", "glob", True)]),
        ("import glob", "glob.glob", []),
        ("from glob import glob", "glob", []),
        ("import glob\nfrom glob import glob", "glob", []),
        ("import glob as files", "files", [("error", "files", False)]),
        ("import os", "os", [("error", "os", False)]),
        ("import glob\nglob = glob.glob", "glob", []),
        ("import glob\ndef glob(pattern): return []", "glob", []),
        ("import glob\nfrom tools import *", "glob", []),
        ("import tools", "tools", []),
        ("import glob\ndef find(): return glob('*')", "list", [("warning", "glob", True)]),
        ("import glob\ndef find(glob): return glob('*')", "list", []),
    ],
)
def test_a_module_that_is_called(start: str, call: str, expected: list[tuple[str, str, bool]]) -> None:
    assert told(start, call) == expected

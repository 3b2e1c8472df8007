"""What stands behind the place where setup.py stops is met by nobody before that is mended (SET308)."""

from __future__ import annotations

import pytest

from rospkg_cli.example import BACKDROPS, SETUP_PY
from rospkg_cli.testing import lint_files


@pytest.mark.parametrize(
    ("before", "expected"),
    [
        ("first_name\nsecond_name\n", ["error", "info"]),
        ("print(first_name, second_name)\n", ["error", "info"]),
        ("if package_name:\n    first_name\nsecond_name\n", ["error", "error"]),
        ("def read():\n    return first_name\n\n\nsecond_name\n", ["warning", "error"]),
        ("import glob\nglob('*')\nsecond_name\n", ["error", "info"]),
    ],
)
def test_one_place_stops_setup_py(before: str, expected: list[str]) -> None:
    text = SETUP_PY.replace("\nsetup(", f"\n{before}\nsetup(", 1)
    found = lint_files({**BACKDROPS["ament_python"], "setup.py": text}, ["SET308"]).findings
    assert [each.severity.value for each in sorted(found, key=lambda each: each.location.span)] == expected

"""Imports by a slip of the name of the package's own Python package."""

from __future__ import annotations

import pytest

from rospkg_cli.example import manifest, scripts, setup_py
from rospkg_cli.testing import lint_files


@pytest.mark.parametrize(
    "text, found",
    [
        ("from rrktl_planner import Curve\n", 1),
        ("from rktl_plannner.curve import Curve\n", 1),
        ("import rktl_planer.curve as curve\n", 1),
        ("from rktl_planner.curve import Curve\n", 0),
        ("from rktl_planners import Curve\n", 0),
        ("from rktl_planner2 import Curve\n", 0),
        ("from rktl_player import Curve\n", 0),
        ("from .rrktl_planner import Curve\n", 0),
        ("try:\n    import rrktl_planner\nexcept ImportError:\n    pass\n", 0),
        ("import sys\nsys.path.append('x')\nimport rrktl_planner\n", 0),
    ],
)
def test_a_slip_of_the_own_name(text: str, found: int) -> None:
    files = {
        "package.xml": manifest().replace("my_pkg", "rktl_planner"),
        "setup.py": setup_py(scripts("a = rktl_planner.a:main")).replace("my_pkg", "rktl_planner"),
        "rktl_planner/__init__.py": "",
        "rktl_planner/curve.py": "class Curve: ...\n",
        "rktl_planner/a.py": f"{text}\n\ndef main(): ...\n",
    }
    told = [each for each in lint_files(files, ["DEP109"]).findings if "nothing known" in each.message]
    assert [each.severity.value for each in told] == ["info"] * found

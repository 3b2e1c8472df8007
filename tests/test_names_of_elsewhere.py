"""Undefined names that another module has: the line that imports them, and the Pythons that still have them."""

from __future__ import annotations

import pytest

from rospkg_cli.example import BACKDROPS, existing_files, scripts, setup_py
from rospkg_cli.testing import lint_files

FILES = {
    **existing_files(BACKDROPS["ament_python"]),
    "setup.py": setup_py(scripts("talker = my_pkg.talker:main")),
    "my_pkg/words.py": (
        "import numpy as np\nimport cv2\nfrom pathlib import Path\nfrom . import sub\nfrom math import pi as PI\n"
        "HELLO = np, cv2, Path, sub, PI\n"
    ),
    "my_pkg/sub.py": "",
}


@pytest.mark.parametrize(
    ("name", "advice"),
    [
        ("Path", "add `from pathlib import Path`"),
        ("PI", "add `from math import pi as PI`"),
        ("np", "add `import numpy as np`"),
        ("cv2", "add `import cv2`"),
        ("sub", "add `from .words import sub`"),
        ("HELLO", "add `from .words import HELLO`"),
    ],
)
def test_where_a_name_is_imported_from(name: str, advice: str) -> None:
    other = "PI" if name == "HELLO" else "HELLO"
    text = f"from .words import {other}\n\n\ndef main():\n    print({other}, {name})\n"
    (found,) = lint_files({**FILES, "my_pkg/talker.py": text}, ["DEP117"]).findings
    assert found.message.endswith(f"; {advice}")


@pytest.mark.parametrize(
    ("page", "line", "level"),
    [
        ("ROS 2 Foxy", "from collections import Mapping", "info"),
        ("ROS 2 Galactic", "import collections\nMapping = collections.Mapping", "info"),
        ("ROS 2 Foxy", "from fractions import gcd as Mapping", "info"),
        ("ROS 2 Foxy", "from itertools import izip as Mapping", "warning"),
        ("ROS 2 Humble", "from collections import Mapping", "warning"),
        ("ROS 2 Foxy and Humble", "from collections import Mapping", "warning"),
        ("", "from collections import Mapping", "warning"),
    ],
)
def test_what_the_python_of_foxy_has(page: str, line: str, level: str) -> None:
    files = {**FILES, "my_pkg/talker.py": f"{line}\n\n\ndef main():\n    print(Mapping)\n", "README.md": page}
    assert [each.severity.value for each in lint_files(files, ["DEP117"]).findings] == [level]

"""Entry points that only a build without links to the sources misses: how pages, scripts and containers build."""

from __future__ import annotations

import pytest

from rospkg_cli.example import BACKDROPS, existing_files, scripts, setup_py
from rospkg_cli.testing import lint_files

SETUP = setup_py(scripts("talker = my_pkg.nodes.talker:main")).replace(
    "find_packages(exclude=['test'])", "[package_name]"
)
FILES = {
    **existing_files(BACKDROPS["ament_python"]),
    "setup.py": SETUP,
    "my_pkg/nodes/__init__.py": "",
    "my_pkg/nodes/talker.py": "def main():\n    print('hello')\n",
}
LINKED = "    colcon build --symlink-install\n"


@pytest.mark.parametrize(
    ("pages", "level"),
    [
        ({"README.md": LINKED}, "info"),
        ({"README.md": "Run `colcon build --packages-up-to my_pkg --symlink-install`\n"}, "info"),
        ({"build.sh": "# colcon build with all it needs\ncolcon build \\\n  --symlink-install\n"}, "info"),
        ({"README.md": LINKED, "clean.sh": "colcon build --cmake-target clean\n"}, "info"),
        ({"README.md": LINKED + "    colcon build --packages-select other\n"}, "info"),
        ({"README.md": LINKED + "    colcon build\n"}, "warning"),
        ({"README.md": LINKED, "Dockerfile": "RUN colcon build --packages-select my_pkg other\n"}, "warning"),
        ({".github/workflows/ci.yml": f"run: {LINKED}"}, "warning"),
        ({".github/workflows/ci.yml": "run: colcon build\n", "README.md": LINKED}, "warning"),
        ({"README.md": "Build with --symlink-install\n"}, "warning"),
        ({"README.md": "    colcon build\n"}, "error"),
        ({}, "error"),
    ],
)
def test_who_builds_without_links(pages: dict[str, str], level: str) -> None:
    assert [each.severity.value for each in lint_files({**FILES, **pages}, ["SET105"]).findings] == [level]

"""Files of `data_files` that are missing, and that a page or a script has people bring or make (SET205)."""

from __future__ import annotations

import pytest

from rospkg_cli.example import BACKDROPS, existing_files, setup_py
from rospkg_cli.testing import lint_files

ENTRY = "        ('share/' + package_name, ['package.xml']),\n"
MAP = "        ('share/' + package_name + '/maps', ['maps/lab.yaml']),\n"
PACKAGE = {**existing_files(BACKDROPS["ament_python"]), "setup.py": setup_py().replace(ENTRY, ENTRY + MAP)}


@pytest.mark.parametrize(
    ("texts", "level"),
    [
        ({}, "error"),
        ({"README.md": "Save the map: `ros2 run nav2_map_server map_saver_cli -f src/my_pkg/maps/lab`\n"}, "info"),
        ({"setup_maps.md": "", "README.md": "Copy your own `lab.yaml` into `maps/`.\n"}, "info"),
        ({"README.md": "    wget https://example.org/lab.yaml -P maps\n"}, "info"),
        ({"README.md": "Unzip it into the folder:\n\n    unzip all.zip -d maps/\n"}, "warning"),
        ({"README.md": "The map is `maps/lab.yaml`.\n"}, "error"),
    ],
)
def test_who_brings_a_file(texts: dict[str, str], level: str) -> None:
    files = {f"src/my_pkg/{path}": text for path, text in PACKAGE.items()}
    (found,) = lint_files(files | texts, ["SET205"]).findings
    assert found.severity.value == level
    assert ("until it is" in found.message) is (level != "error")

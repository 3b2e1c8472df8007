"""Scripts that say themselves that nobody uses them, and those that are given to Python by their paths (CMK105)."""

from __future__ import annotations

import pytest

from rospkg_cli.checks.repository.spare_files import is_spare
from rospkg_cli.example import CMAKE, manifest
from rospkg_cli.files import PackageFiles
from rospkg_cli.testing import lint_files
from rospkg_cli.tree import MemoryTree

NODE = "import rclpy\n\nif __name__ == '__main__':\n    rclpy.init()\n"


@pytest.mark.parametrize(
    "head",
    [
        "# No longer used\n",
        "'''\nMerged into driver.py,\nkept here as a backup\n'''\n#!/usr/bin/env python3\n",
        '"""This node is deprecated, use the other one."""\n',
        "# DEPRECATED\n",
        "# unused: see driver.py\n",
        "# the script has been replaced\n",
        "\n# -*- coding: utf-8 -*-\n# superseded by driver.py\n",
        "'''\n仅作备用\n'''\n",
        "// This file is obsolete\n",
    ],
)
def test_a_file_that_says_so(head: str) -> None:
    files = PackageFiles(MemoryTree.of({"a.py": head + NODE}))
    assert is_spare(files, "a.py")


@pytest.mark.parametrize(
    "head",
    [
        "",
        "# Licensed under the Apache License; you may not use this file except in compliance with it\n",
        "# neither the name may be used to endorse products\n",
        "# The gain is usually not needed\n",
        "# Removes unused maps\n",
        "# Saves a backup of the map\n",
        "# Hides what is deprecated\n",
        "import rclpy\n# no longer used\n",
        '"""Drives the robot.',
    ],
)
def test_a_file_that_is_used(head: str) -> None:
    assert not is_spare(PackageFiles(MemoryTree.of({"a.py": head + NODE})), "a.py")


BARE = {"scripts/driver.py": NODE}
KEPT = {"scripts/driver.py": f"'''\nno longer used\n'''\n{NODE}"}
RUNS = {"README.md": "Start it: `ros2 run my_pkg driver.py`\n"}


@pytest.mark.parametrize(
    ("files", "level"),
    [
        (BARE, "error"),
        (KEPT, "info"),
        (KEPT | RUNS, "error"),
        ({"scripts/driver_old.py": NODE}, "info"),
        (KEPT | {"launch/a.launch.xml": '<launch><node pkg="my_pkg" exec="driver.py"/></launch>\n'}, "error"),
        (BARE | {"README.md": "Start it: `python3 src/my_pkg/scripts/driver.py`\n"}, "info"),
        (BARE | {"start.sh": "python3 scripts/driver.py\n", "README.md": "`ros2 run my_pkg driver.py`\n"}, "error"),
        (BARE | {"start.sh": "python3 scripts/driver.py\n", "README.md": "`ros2 run my_pkg other`\n"}, "error"),
    ],
)
def test_who_starts_a_script_without_its_first_line(files: dict[str, str], level: str) -> None:
    lines = "file(GLOB SCRIPTS scripts/*.py)\ninstall(PROGRAMS ${SCRIPTS} DESTINATION lib/${PROJECT_NAME})\n"
    package = {
        "package.xml": manifest("", "ament_cmake"),
        "CMakeLists.txt": CMAKE.replace("ament_package", f"{lines}ament_package"),
    }
    found = lint_files(package | files, ["CMK105"]).findings
    assert [each.severity.value for each in found] == [level]

"""Odd CMake: commands without what they need, and names that CMake would not take. No rule may stumble over them."""

from __future__ import annotations

import pytest

from rospkg_cli.example import CMAKE, manifest
from rospkg_cli.testing import lint_files

FILES = {"launch/a.launch.py": "def generate_launch_description():\n    return LaunchDescription()\n"}
FALLEN = "RPK005"


def package(lines: str, name: str = "my_pkg") -> dict[str, str]:
    cmake = CMAKE.replace("ament_package()", f"{lines}\nament_package()")
    return {"package.xml": manifest("", "ament_cmake", name), "CMakeLists.txt": cmake, **FILES}


def fallen(files: dict[str, str]) -> list[str]:
    """Return what rules broke on."""
    return [finding.message for finding in lint_files(files).findings if finding.code == FALLEN]


@pytest.mark.parametrize("items", ["", '""', "${nothing}"])
@pytest.mark.parametrize("kind", ["DIRECTORY", "FILES", "PROGRAMS", "TARGETS"])
def test_an_install_rule_may_have_no_item(kind: str, items: str) -> None:
    lines = f"add_library(l SHARED src/a.cpp)\ninstall({kind} {items} DESTINATION share/${{PROJECT_NAME}})"
    assert fallen(package(lines)) == []
    assert fallen(package(lines.replace("share", "lib"))) == []

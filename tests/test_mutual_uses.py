"""Two packages whose launch files start nodes of each other: declaring both would be a cycle."""

from __future__ import annotations

from pathlib import Path

import pytest
from in_process import run_here
from writing import Write

from rospkg_cli.example import manifest

LAUNCH = '<launch>\n  <node pkg="{}" exec="driver"/>\n</launch>\n'


@pytest.fixture
def ws(tmp_path: Path, write: Write) -> Path:
    text = "project({})\nfind_package(ament_cmake REQUIRED)\nadd_executable(driver d.cpp)\n"
    text += "install(TARGETS driver DESTINATION lib/${{PROJECT_NAME}})\n"
    text += "install(DIRECTORY launch DESTINATION share/${{PROJECT_NAME}})\nament_package()\n"
    for name, other in (("one_pkg", "two_pkg"), ("two_pkg", "one_pkg")):
        files = {
            "package.xml": manifest("", "ament_cmake").replace("my_pkg", name),
            "CMakeLists.txt": text.format(name),
            "d.cpp": "int main() {}\n",
            "launch/up.launch.xml": LAUNCH.format(other),
        }
        write(tmp_path / "ws" / name, files)
    return tmp_path / "ws"


def test_neither_is_declared_safely(ws: Path) -> None:
    shown = run_here("lint", "--diff", "--select", "DEP103", cwd=ws)
    assert (shown.returncode, shown.stdout) == (0, "")


def test_one_use_is(ws: Path) -> None:
    (ws / "two_pkg/launch/up.launch.xml").write_text(LAUNCH.format("two_pkg"))
    assert "+  <exec_depend>two_pkg</exec_depend>" in run_here("lint", "--diff", "--select", "DEP103", cwd=ws).stdout

"""Packages of interfaces that `new` writes, under Debian's rosidl, ament_cmake and linters.

Debian lacks the package that names rosidl's generators; a stand-in does (`standins/prefix`).
"""

from __future__ import annotations

import os
from pathlib import Path

import pytest
from messages import message_prefix
from shell import Shell
from testing_new import PREFIX, linted, plan, results, write

from rospkg_cli.scaffold.plan import Plan

pytestmark = [pytest.mark.debian, pytest.mark.network]
ASKED = {
    "msgs": (
        "RobotStatus:builtin_interfaces/Time stamp, float32 battery_level, string current_task",
        "Path:RobotStatus[] steps, uint8 OK = 0, string<=10 name \"a, b\", float64[3] at [1.0, 2.0, 3.0]",
    ),
    "srvs": ("GoTo:float32 x, float32 y --- bool ok, string why", "Ping"),
    "actions": ("Fly",),
}  # fmt: skip


def interfaces(name: str, **asked: tuple[str, ...]) -> Plan:
    return plan(name, template="interfaces", distro="humble", **asked)


def test_rosidl_generates_what_was_asked_for(debian_colcon: Shell, tmp_path: Path) -> None:
    write(interfaces("my_interfaces", **ASKED), tmp_path)
    prefixes = os.pathsep.join((str(PREFIX), str(message_prefix(debian_colcon))))
    built = debian_colcon.run("colcon", "build", cwd=tmp_path, CMAKE_PREFIX_PATH=prefixes)
    assert (built.returncode, built.stderr) == (0, "")
    made = tmp_path / "install/my_interfaces/include/my_interfaces/my_interfaces"
    assert {path.relative_to(made).as_posix() for path in made.glob("*/*.hpp")} == {
        "msg/robot_status.hpp", "msg/path.hpp", "srv/go_to.hpp", "srv/ping.hpp", "action/fly.hpp",
    }  # fmt: skip


def test_every_test_passes_and_none_is_skipped(debian_colcon: Shell, tmp_path: Path) -> None:
    write(interfaces("plain_interfaces", msgs=("Number:int64 number",)), tmp_path)
    prefix = {"CMAKE_PREFIX_PATH": str(PREFIX)}
    assert debian_colcon.run("colcon", "build", cwd=tmp_path, **prefix).returncode == 0
    tested = debian_colcon.run("colcon", "test", cwd=tmp_path, **prefix)
    assert (tested.returncode, tested.stderr) == (0, "")
    found = results(debian_colcon, tmp_path)
    assert found.pop("tests") >= 3
    assert found == {"errors": 0, "failures": 0, "skipped": 0}


@pytest.mark.parametrize("place", ["git root", "plain folder"])
def test_every_linter_is_content(shell: Shell, tmp_path: Path, place: str) -> None:
    folder = write(interfaces("my_interfaces", **ASKED), tmp_path)
    if place == "git root":
        assert shell.run("git", "init", "--quiet", cwd=folder).returncode == 0
    linted(shell, folder, ("copyright", "lint_cmake", "xmllint"))

"""Packages that describe a robot or start one, under Debian's ament_cmake, check_urdf and linters; xacro is PyPI's."""

from __future__ import annotations

import os
from pathlib import Path

import pytest
from conftest import DEBIAN_MODULES, DEBIAN_PYTHON, tools
from messages import message_prefix
from planned import ADA
from shell import Shell
from testing_new import PREFIX, around, linted, plan, results, write
from venvs import COLCON, venv

from rospkg_cli.scaffold.answers import Request
from rospkg_cli.scaffold.family import plan_family, write_family
from rospkg_cli.scaffold.family_root import family_root
from rospkg_cli.scaffold.plan import Plan

pytestmark = [pytest.mark.debian, pytest.mark.network]
LINTERS = ("copyright", "flake8", "lint_cmake", "mypy", "pep257", "xmllint")
LONG = "a_rather_long_name_for_a_robot_that_somebody_had"


@pytest.fixture
def colcon(shell: Shell) -> Shell:
    """A shell in which colcon finds Debian's ament, and tests find xacro."""
    wanted = ("setuptools==65.5.1", *COLCON, "xacro")
    return shell.before(tools(lambda: venv(DEBIAN_PYTHON, wanted, DEBIAN_MODULES)))


@pytest.mark.parametrize("options", [(), ("--symlink-install",)], ids=["copied", "symlinked"])
def test_a_description_builds_and_check_urdf_accepts_it(
    colcon: Shell, tmp_path: Path, options: tuple[str, ...]
) -> None:
    write(plan("my_robot_description", template="description", depends=("std_msgs", "launch_testing")), tmp_path)
    built = colcon.run("colcon", "build", *options, cwd=tmp_path)
    assert (built.returncode, built.stderr) == (0, "")
    share = tmp_path / "install/my_robot_description/share/my_robot_description"
    for path in ("urdf/my_robot.urdf.xacro", "launch/view.launch.py", "rviz/view.rviz"):
        assert (share / path).is_file()
    tested = colcon.run("colcon", "test", cwd=tmp_path)
    assert (tested.returncode, tested.stderr) == (0, "")
    found = results(colcon, tmp_path)
    assert found.pop("tests") > 5
    assert found == {"errors": 0, "failures": 0, "skipped": 0}


@pytest.mark.parametrize("place", ["git root", "plain folder"])
@pytest.mark.parametrize("name", ["my_robot_description", LONG + "_description"])
def test_every_linter_is_content_with_a_description(shell: Shell, tmp_path: Path, name: str, place: str) -> None:
    folder = write(plan(name, template="description"), tmp_path)
    if place == "git root":
        assert shell.run("git", "init", "--quiet", cwd=folder).returncode == 0
    linted(shell, folder, LINTERS)


def bringup(name: str = "my_robot_bringup") -> Plan:
    robot = name.removesuffix("_bringup")
    there = around(plan(robot, nodes=("talker", "counter:timer")), plan(f"{robot}_description", template="description"))
    return plan(name, there, template="bringup", depends=(robot, f"{robot}_description"), nodes=("demo_nodes_py/ear",))


def test_a_bringup_builds_and_its_tests_pass(colcon: Shell, tmp_path: Path) -> None:
    write(bringup(), tmp_path)
    built = colcon.run("colcon", "build", cwd=tmp_path)
    assert (built.returncode, built.stderr) == (0, "")
    share = tmp_path / "install/my_robot_bringup/share/my_robot_bringup"
    for path in ("launch/my_robot_bringup.launch.py", "config/my_robot.yaml", "config/params.yaml"):
        assert (share / path).is_file()
    tested = colcon.run("colcon", "test", cwd=tmp_path)
    assert (tested.returncode, tested.stderr) == (0, "")
    found = results(colcon, tmp_path)
    assert found.pop("tests") > 5
    assert found == {"errors": 0, "failures": 0, "skipped": 0}


@pytest.mark.parametrize("place", ["git root", "plain folder"])
@pytest.mark.parametrize("name", ["my_robot_bringup", "a_long_name_for_a_robot_that_somebody_had_bringup"])
def test_every_linter_is_content_with_a_bringup(shell: Shell, tmp_path: Path, name: str, place: str) -> None:
    folder = write(bringup(name), tmp_path)
    if place == "git root":
        assert shell.run("git", "init", "--quiet", cwd=folder).returncode == 0
    linted(shell, folder, LINTERS)


@pytest.mark.parametrize("place", ["git root", "plain folder"])
def test_every_linter_is_content_with_an_empty_bringup(shell: Shell, tmp_path: Path, place: str) -> None:
    folder = write(plan("my_robot_bringup", template="bringup"), tmp_path)
    if place == "git root":
        assert shell.run("git", "init", "--quiet", cwd=folder).returncode == 0
    linted(shell, folder, LINTERS)


FAMILIES = {
    "copied": ("mixed", ()),
    "symlinked": ("mixed", ("--symlink-install",)),
    "in Python": ("ament_python", ()),
    "in C++": ("ament_cmake", ()),
}
STATUS = "RobotStatus:std_msgs/Header header, float32 battery_level, string current_task, uint8 error_status"


@pytest.mark.parametrize("name", FAMILIES)
def test_a_family_builds(colcon: Shell, debian_colcon: Shell, tmp_path: Path, name: str) -> None:
    template, options = FAMILIES[name]
    asked = {**ADA, "distro": "humble", "template": template, "msgs": (STATUS,), "srvs": ("Go",)}
    request = Request("my_robot", **asked)
    plans = plan_family(request, tmp_path, {})
    write_family(plans, tmp_path / "src", family_root(request, tmp_path / "src", "humble"))
    prefixes = os.pathsep.join((str(PREFIX), str(message_prefix(debian_colcon))))
    built = colcon.run("colcon", "build", *options, cwd=tmp_path, CMAKE_PREFIX_PATH=prefixes)
    assert (built.returncode, built.stderr) == (0, "")
    home = tmp_path / "install/my_robot/lib/my_robot"
    assert {path.name for path in home.iterdir()} == {node.name for node in plans[2].answers.nodes}
    assert all(os.access(path, os.X_OK) for path in home.iterdir())
    assert (tmp_path / "install/my_robot_bringup/share/my_robot_bringup/config/my_robot.yaml").is_file()
    if name == "copied":
        tested = colcon.run("colcon", "test", cwd=tmp_path, CMAKE_PREFIX_PATH=prefixes)
        assert (tested.returncode, tested.stderr) == (0, "")
        found = results(colcon, tmp_path)
        assert found.pop("tests") > 20
        assert found == {"errors": 0, "failures": 0, "skipped": 0}

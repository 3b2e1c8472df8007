"""The exercises of a textbook's chapter on packages, each in one command."""

from __future__ import annotations

import sys
from pathlib import Path
from unittest.mock import patch

import pytest
from planned import ADA

from rospkg_cli.__main__ import main

WHO = ["--maintainer", ADA["maintainer"], "--email", ADA["email"], "--distro", "jazzy", "--into", "src"]


@pytest.fixture(autouse=True)
def workspace(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(tmp_path)
    return tmp_path


def rospkg(*words: str) -> int:
    """Return the exit status of a command."""
    with patch.object(sys, "argv", ["rospkg", *words]):
        return main()


def written(*words: str) -> Path:
    assert rospkg("new", *words, *WHO) == 0
    assert rospkg("lint", "--pedantic", "--release", "src") == 0
    return Path("src")


def test_a_package_for_simple_navigation() -> None:
    nodes = ("--node", "nav_node:subscriber:nav_msgs/Odometry", "--node", "path_planner:publisher:nav_msgs/Path")
    package = written("my_robot_nav", *nodes, "--depends", "geometry_msgs") / "my_robot_nav"
    for path in ("package.xml", "setup.py", "my_robot_nav/nav_node.py", "launch/my_robot_nav.launch.py"):
        assert (package / path).is_file()
    manifest = (package / "package.xml").read_text()
    for key in ("geometry_msgs", "nav_msgs", "rclpy"):
        assert f"<exec_depend>{key}</exec_depend>" in manifest


def test_a_message_of_ones_own_used_in_a_node() -> None:
    message = "RobotStatus:float32 battery_level, string current_task, uint8 OK=0, uint8 error_status"
    src = written("my_robot", "--family", "--msg", message)
    assert "float32 battery_level\n" in (src / "my_robot_interfaces/msg/RobotStatus.msg").read_text()
    node = (src / "my_robot/my_robot/my_robot_node.py").read_text()
    assert "from my_robot_interfaces.msg import RobotStatus\n" in node
    assert "message.current_task = ''\n" in node


def test_several_executables() -> None:
    package = written("my_robot_nav", "--node", "talker,listener:subscriber,planner:timer") / "my_robot_nav"
    setup = (package / "setup.py").read_text()
    for name in ("talker", "listener", "planner"):
        assert f"'{name} = my_robot_nav.{name}:main',\n" in setup


def test_a_library_from_outside_by_its_rosdep_key(capsys: pytest.CaptureFixture[str]) -> None:
    package = written("my_robot_nav", "--depends", "python3-numpy,python3-opencv") / "my_robot_nav"
    assert "<exec_depend>python3-numpy</exec_depend>" in (package / "package.xml").read_text()
    assert rospkg("new", "other_pkg", "--depends", "opencv-python,python3-yaml", *WHO) == 2
    assert "write `--depends python3-opencv,python3-yaml`" in capsys.readouterr().err

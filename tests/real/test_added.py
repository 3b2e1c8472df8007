"""What `rospkg add` puts into packages that exist, built by the real colcon: executables are where `ros2 run` looks."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest
from messages import message_prefix
from shell import Shell
from testing_new import PREFIX, STANDINS

from rospkg_cli.example import manifest
from rospkg_cli.scaffold.template import load_template

pytestmark = pytest.mark.network
KINDS = tuple(f"n_{kind.replace('-', '_')}:{kind}" for kind in load_template("ament_python").kinds)
CPP_KINDS = ("c_talker:publisher:cpp", "c_part:component:cpp", "c_idler:empty:cpp")

SETUP = """\
from setuptools import find_packages, setup

setup(
    name="robot",
    version="0.1.0",
    packages=find_packages(),
    data_files=[
        ("share/ament_index/resource_index/packages", ["resource/robot"]),
        ("share/robot", ["package.xml"]),
    ],
    entry_points={"console_scripts": ["old = robot.old:main"]}
)
"""
PYTHON = {
    "package.xml": manifest().replace("my_pkg", "robot"),
    "setup.py": SETUP,
    "setup.cfg": "[develop]\nscript_dir=$base/lib/robot\n[install]\ninstall_scripts=$base/lib/robot\n",
    "resource/robot": "",
    "robot/__init__.py": "",
    "robot/old.py": "def main():\n    print('old')\n",
}
CMAKE = """\
cmake_minimum_required(VERSION 3.16)
project(robot)
find_package(ament_cmake REQUIRED)

set(programs old)
add_executable(old src/old.cpp)
install(TARGETS ${programs} DESTINATION lib/${PROJECT_NAME})

ament_package()
"""
UPPER = "CMAKE_MINIMUM_REQUIRED(VERSION 3.16)\nPROJECT(robot)\nFIND_PACKAGE(ament_cmake REQUIRED)\nAMENT_PACKAGE()\n"
COMPILED = {
    "package.xml": manifest("  <buildtool_depend>ament_cmake</buildtool_depend>\n", build_type="ament_cmake").replace(
        "my_pkg", "robot"
    ),
    "CMakeLists.txt": CMAKE,
    "src/old.cpp": "int main() {return 0;}\n",
}


def written(files: dict[str, str], workspace: Path) -> Path:
    for path, text in files.items():
        target = workspace / "src" / "robot" / path
        target.parent.mkdir(parents=True, exist_ok=True)
        target.write_text(text)
    return workspace / "src" / "robot"


def rospkg(package: Path, *arguments: str) -> None:
    command = [sys.executable, "-m", "rospkg_cli", *arguments]
    done = subprocess.run(command, cwd=package, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr


def installed(workspace: Path, name: str) -> bool:
    return os.access(workspace / "install" / "robot" / "lib" / "robot" / name, os.X_OK)


def names(kinds: tuple[str, ...]) -> list[str]:
    return [kind.partition(":")[0] for kind in kinds]


def test_nodes_in_python(one_colcon: Shell, tmp_path: Path) -> None:
    """Against stand-ins for rclpy and messages."""
    package = written(PYTHON, tmp_path)
    rospkg(package, "add", "node", *KINDS)
    rospkg(package, "add", "launch", "up")
    rospkg(package, "add", "params", "robot")
    done = one_colcon.run("colcon", "build", cwd=tmp_path)
    assert (done.returncode, done.stderr) == (0, "")
    assert all(installed(tmp_path, name) for name in ["old", *names(KINDS)])
    share = tmp_path / "install" / "robot" / "share" / "robot"
    assert (share / "launch" / "up.launch.py").is_file()
    assert (share / "config" / "robot.yaml").is_file()
    [modules] = (tmp_path / "install" / "robot").glob("lib/python3*/site-packages")
    log = tmp_path / "log.jsonl"
    log.touch()
    variables = {"PYTHONPATH": f"{modules}{os.pathsep}{STANDINS}", "STANDIN_LOG": str(log)}
    program = tmp_path / "install" / "robot" / "lib" / "robot" / "n_empty"
    node = subprocess.Popen([program], env={**one_colcon.variables, **variables}, stderr=subprocess.PIPE, text=True)
    assert node.stderr is not None
    assert "ready" in node.stderr.readline()
    node.terminate()
    assert node.wait(timeout=30) == 0


@pytest.mark.debian
@pytest.mark.parametrize("form", ["lower", "upper"])
def test_nodes_in_cpp(debian_colcon: Shell, tmp_path: Path, form: str) -> None:
    """Against stand-ins for rclcpp, and real messages."""
    prefixes = os.pathsep.join((str(PREFIX), str(message_prefix(debian_colcon))))
    built = Shell({**debian_colcon.variables, "CMAKE_PREFIX_PATH": prefixes})
    files = COMPILED if form == "lower" else {**COMPILED, "CMakeLists.txt": UPPER}
    package = written(files, tmp_path)
    rospkg(package, "add", "node", *CPP_KINDS)
    rospkg(package, "add", "node", "script:subscriber:python")
    rospkg(package, "add", "launch", "up:xml")
    rospkg(package, "add", "test", "thing")
    done = built.run("colcon", "build", cwd=tmp_path)
    assert (done.returncode, done.stderr) == (0, "")
    assert all(installed(tmp_path, name) for name in [*names(CPP_KINDS), "script"])
    assert (tmp_path / "install/robot/share/robot/launch/up.launch.xml").is_file()
    rospkg(package, "remove", "launch", "up:xml")  # it starts the nodes
    rospkg(package, "remove", "test", "thing")
    rospkg(package, "remove", "node", "script")
    rospkg(package, "remove", "node", *names(CPP_KINDS))
    assert {
        path.relative_to(package).as_posix(): path.read_text() for path in package.rglob("*") if path.is_file()
    } == (files)

"""C++ packages that `new` writes: built, tested and judged by Debian's ament_cmake and linters.

rclcpp and its kin are stand-ins, headers with what nodes use of them (`standins/prefix`): the code is compiled and
linked, not run. The messages are real rosidl's.
"""

from __future__ import annotations

import os
from pathlib import Path

import pytest
from conftest import DEBIAN_MODULES
from messages import message_prefix
from shell import Shell
from testing_new import PREFIX, around, linted, plan, results, write
from venvs import COLCON, SETUPTOOLS, venv

from rospkg_cli.ros.licenses import LICENSES
from rospkg_cli.scaffold.plan import Plan
from rospkg_cli.scaffold.template import load_template

pytestmark = [pytest.mark.debian, pytest.mark.network]
KINDS = load_template("ament_cmake").kinds
OTHERS = load_template("ament_python").kinds
IN_PYTHON = tuple(f"p_{kind.replace('-', '_')}:{kind}:python" for kind in OTHERS)
LINTERS = ("copyright", "cpplint", "flake8", "lint_cmake", "pep257", "uncrustify", "xmllint")
ALL = tuple(f"n_{kind.replace('-', '_')}:{kind}" for kind in KINDS)


def cpp(name: str = "my_robot_nav", **asked: object) -> Plan:
    return plan(name, template="ament_cmake", **asked)


PLANS = {
    "default": lambda: cpp(),
    "all": lambda: cpp(nodes=ALL, distro="humble"),
    "bare": lambda: cpp(nodes=("idle:empty",), depends=("std_msgs", "eigen", "launch_testing"), launch="xml"),
    "component": lambda: cpp(
        nodes=("loaded:component",), maintainer="Adá 'the first'; & <Lovelace> {{ name }}", launch="yaml"
    ),
    "least": lambda: cpp(launch="none", params=False, tests="minimal"),
    "mixed": lambda: plan(template="mixed", distro="humble", nodes=ALL + IN_PYTHON, depends=("python3-numpy",)),
    "mixed bare": lambda: plan(template="mixed", nodes=("idle:empty", "adder:service:python")),
}


@pytest.fixture
def built(debian_colcon: Shell) -> Shell:
    """A shell in which CMake finds the messages, and the stand-ins."""
    prefixes = os.pathsep.join((str(PREFIX), str(message_prefix(debian_colcon))))
    return Shell({**debian_colcon.variables, "CMAKE_PREFIX_PATH": prefixes})


@pytest.mark.parametrize("name", PLANS)
def test_it_builds_and_its_tests_pass(built: Shell, tmp_path: Path, name: str) -> None:
    planned = PLANS[name]()
    write(planned, tmp_path)
    made = built.run("colcon", "build", cwd=tmp_path)
    assert (made.returncode, made.stderr) == (0, "")
    prefix = tmp_path / "install/my_robot_nav"
    for node in planned.answers.nodes:
        assert os.access(prefix / "lib/my_robot_nav" / node.name, os.X_OK)
    for logic in planned.answers.logics_in("cpp"):
        assert (prefix / f"include/my_robot_nav/my_robot_nav/{logic}.hpp").is_file()
    launched = planned.answers.launch
    assert not launched or (prefix / f"share/my_robot_nav/launch/my_robot_nav.launch.{launched}").is_file()
    assert (prefix / "share/my_robot_nav/config/params.yaml").is_file() == bool(planned.answers.sections)
    tested = built.run("colcon", "test", cwd=tmp_path)
    assert (tested.returncode, tested.stderr) == (0, "")
    found = results(built, tmp_path)
    assert found.pop("tests") > (len(LINTERS) if planned.answers.tests == "ament" else 0)
    assert found == {"errors": 0, "failures": 0, "skipped": 0}


@pytest.mark.parametrize(("name", "place"), [*((name, "git root") for name in PLANS), ("least", "plain folder")])
def test_every_linter_of_ament_is_content(shell: Shell, tmp_path: Path, name: str, place: str) -> None:
    """In plain folders they run as tests of the packages, above; only the least package has none."""
    folder = write(PLANS[name](), tmp_path)
    if place == "git root":
        assert shell.run("git", "init", "--quiet", cwd=folder).returncode == 0
    linted(shell, folder, (*LINTERS, *(("mypy",) if "mixed" in name else ())))


@pytest.mark.parametrize("license", [each.spdx for each in LICENSES if each.header_known])
def test_linters_know_every_license(shell: Shell, tmp_path: Path, license: str) -> None:
    folder = write(cpp(license=license), tmp_path)
    linted(shell, folder, ("copyright", "cpplint", "uncrustify"))


def test_another_package_can_use_its_library(built: Shell, tmp_path: Path) -> None:
    write(cpp("first_pkg"), tmp_path)
    user = tmp_path / "src/user_pkg"
    user.mkdir()
    (user / "package.xml").write_text(
        '<package format="3"><name>user_pkg</name><version>0.1.0</version><description>uses it</description>'
        '<maintainer email="ada@example.org">Ada</maintainer><license>MIT</license>'
        "<buildtool_depend>ament_cmake</buildtool_depend><depend>first_pkg</depend>"
        "<export><build_type>ament_cmake</build_type></export></package>"
    )
    (user / "CMakeLists.txt").write_text(
        "cmake_minimum_required(VERSION 3.20)\nproject(user_pkg)\nfind_package(ament_cmake REQUIRED)\n"
        "find_package(first_pkg REQUIRED)\nadd_executable(use use.cpp)\n"
        "target_link_libraries(use first_pkg::first_pkg)\nament_package()\n"
    )
    (user / "use.cpp").write_text(
        '#include "first_pkg/greeting.hpp"\nint main() {return first_pkg::Greeting("a").say() == "a 1" ? 0 : 1;}\n'
    )
    made = built.run("colcon", "build", cwd=tmp_path)
    assert (made.returncode, made.stderr) == (0, "")


@pytest.mark.parametrize("template", ["ament_cmake", "mixed", "interfaces", "description", "bringup"])
def test_the_newest_cmake_has_nothing_to_say(built: Shell, tmp_path: Path, template: str) -> None:
    folder = write(plan("a_package", template=template), tmp_path)
    newest = venv("/usr/bin/python3", ("cmake>=4",)) / "bin" / "cmake"
    python = "-DPython3_EXECUTABLE=/usr/bin/python3"
    said = built.run(newest, "-S", folder, "-B", tmp_path / "build", python, cwd=tmp_path)
    assert (said.returncode, said.stderr) == (0, "")


MESSAGE = "RobotStatus:std_msgs/Header header, float32 battery_level, string current_task, uint8 error_status"
GO, FLY = "Go:std_msgs/Header at, string where --- bool ok, string why", "Fly:int32 height --- bool ok --- float32 rest"
STATUS_NODES = (
    "status:publisher:RobotStatus@/status:transient_local", "monitor:subscriber:RobotStatus:sensor_data",
    "other:RobotStatus:python:best_effort", "late:subscriber:RobotStatus@~/a_b/c:python:transient_local",
    "scan:subscriber:RobotStatus:python:sensor_data",
    *(f"all_{language}:publisher:RobotStatus@out:{language}+subscriber:RobotStatus@/in+service:Go+client:Go@ask"
      for language in ("cpp", "python")),
    *(
        f"{kind.replace('-', '_')}_in_{language}:{kind}:{name}:{language}"
        for kind, name in (
            ("service", "Go"), ("client", "Go"), ("action-server", "Fly"), ("action-client", "Fly@fly/away"),
        )
        for language in ("cpp", "python")
    ),
)  # fmt: skip


def test_nodes_use_interfaces_of_the_workspace(built: Shell, tmp_path: Path) -> None:
    interfaces = plan(
        "my_robot_interfaces", template="interfaces", distro="humble", msgs=(MESSAGE,), srvs=(GO,), actions=(FLY,)
    )
    planned = plan("my_robot", around(interfaces), template="mixed", nodes=STATUS_NODES)
    write(interfaces, tmp_path)
    folder = write(planned, tmp_path)
    linted(built, folder, (*LINTERS, "mypy"))
    made = built.run("colcon", "build", "--packages-up-to", "my_robot", cwd=tmp_path)
    assert (made.returncode, made.stderr) == (0, "")


@pytest.mark.parametrize("setuptools", SETUPTOOLS)
def test_the_python_of_a_mixed_package_builds_with_each_setuptools(
    built: Shell, tmp_path: Path, setuptools: str
) -> None:
    """ament_cmake runs `setup.py egg_info` with what CMake finds beside colcon."""
    write(plan(template="mixed", nodes=("idle:empty", "other:empty:python"), tests="none"), tmp_path)
    colcon = built.before(venv("/usr/bin/python3", (f"setuptools=={setuptools}", *COLCON), DEBIAN_MODULES) / "bin")
    made = colcon.run("colcon", "build", cwd=tmp_path)
    assert (made.returncode, made.stderr) == (0, "")
    prefix = tmp_path / "install/my_robot_nav"
    [modules] = prefix.glob("l*/**/*-packages/my_robot_nav")
    assert (modules / "py.typed").is_file()
    assert os.access(prefix / "lib/my_robot_nav/other", os.X_OK)

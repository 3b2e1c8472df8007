"""What `new` writes, under the real tools: colcon with each setuptools, catkin_pkg, Debian's ament linters."""

from __future__ import annotations

import os
import shutil
import signal
import subprocess
import time
from pathlib import Path

import pytest
from shell import Shell
from testing_new import STANDINS, linted, plan, results, write

from rospkg_cli.ros.licenses import LICENSES
from rospkg_cli.scaffold.template import load_template

NASTY = {
    "description": 'It\'s "quoted", \\ & <b>bold</b> {{ name }} ${HOME} %s 機器人 \u202e ' + "and rather long " * 8,
    "maintainer": "Adá \"the 'first'\" <Lovelace> & \\ {{ name }}",
}
ALL = tuple(f"n_{kind.replace('-', '_')}:{kind}" for kind in load_template("ament_python").kinds)
PLANS = {
    "default": lambda: plan(),
    "nodes": lambda: plan(nodes=("talker", "listener"), depends=("sensor_msgs", "launch_testing"), launch="xml"),
    "nasty": lambda: plan(**NASTY),
    "kinds": lambda: plan(
        nodes=tuple(f"n_{kind.replace('-', '_')}:{kind}" for kind in load_template("ament_python").kinds)
    ),
    "bare": lambda: plan(nodes=("adder:service",), launch="yaml"),
    "least": lambda: plan(launch="none", params=False, tests="minimal"),
}
LINTERS = ("copyright", "flake8", "mypy", "pep257", "xmllint")


@pytest.fixture
def workspace(tmp_path: Path) -> Path:
    return tmp_path / "ws"


@pytest.mark.network
@pytest.mark.parametrize("options", [(), ("--symlink-install",)], ids=["copied", "symlinked"])
def test_colcon_builds_it_and_says_nothing(colcon: Shell, workspace: Path, options: tuple[str, ...]) -> None:
    write(plan(nodes=("talker", "listener")), workspace)
    write(plan("nasty_pkg", **NASTY), workspace)
    built = colcon.run("colcon", "build", *options, cwd=workspace)
    assert (built.returncode, built.stderr) == (0, "")
    for name, nodes in (("my_robot_nav", ("talker", "listener")), ("nasty_pkg", ("nasty_pkg_node",))):
        prefix = workspace / "install" / name
        for node in nodes:
            assert os.access(prefix / "lib" / name / node, os.X_OK)
        assert (prefix / "share/ament_index/resource_index/packages" / name).is_file()
        for path in ("package.xml", "config/params.yaml", f"launch/{name}.launch.py"):
            assert (prefix / "share" / name / path).is_file()
        if not options:
            assert list(prefix.glob(f"lib/python3*/site-packages/{name}/py.typed"))
            assert not list(prefix.glob("lib/python3*/site-packages/test"))


@pytest.mark.network
@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
def test_what_was_installed_runs_until_it_is_stopped(
    one_colcon: Shell, workspace: Path, number: signal.Signals
) -> None:
    """Against stand-ins for rclpy and messages, since no package index has the real ones."""
    write(plan(), workspace)
    assert one_colcon.run("colcon", "build", cwd=workspace).returncode == 0
    prefix = workspace / "install" / "my_robot_nav"
    [modules] = prefix.glob("lib/python3*/site-packages")
    log = workspace / "log.jsonl"
    log.touch()
    variables = {
        **one_colcon.variables,
        "PYTHONPATH": f"{modules}{os.pathsep}{STANDINS}",
        "STANDIN_LOG": str(log),
        "STANDIN_PARAMS": str(prefix / "share/my_robot_nav/config/params.yaml"),
    }
    program = prefix / "lib" / "my_robot_nav" / "my_robot_nav_node"
    node = subprocess.Popen([program], env=variables, stderr=subprocess.PIPE, text=True)
    for _ in range(3000):
        if '"publish"' in log.read_text() or node.poll() is not None:
            break
        time.sleep(0.01)
    node.send_signal(number)
    _, said = node.communicate(timeout=30)
    assert (node.returncode, said) == (0, "[INFO] Hello 1\n")


@pytest.mark.network
def test_colcon_runs_its_tests(colcon: Shell, workspace: Path) -> None:
    """Those that need no ament: that they run at all depends on how setuptools shows `extras_require`."""
    write(plan(tests="minimal"), workspace)
    assert colcon.run("colcon", "build", cwd=workspace).returncode == 0
    tested = colcon.run("colcon", "test", cwd=workspace)
    assert (tested.returncode, tested.stderr) == (0, "")
    assert results(colcon, workspace) == {"tests": 4, "errors": 0, "failures": 0, "skipped": 0}


@pytest.mark.debian
@pytest.mark.network
@pytest.mark.parametrize("name", PLANS)
def test_all_its_tests_pass_with_ament_and_none_is_skipped(debian_colcon: Shell, workspace: Path, name: str) -> None:
    """But for the launch test: Debian has no launch_testing."""
    planned = PLANS[name]()
    (write(planned, workspace) / "test/test_launch.py").unlink(missing_ok=True)
    built = debian_colcon.run("colcon", "build", cwd=workspace)
    assert (built.returncode, built.stderr) == (0, "")
    tested = debian_colcon.run("colcon", "test", cwd=workspace)
    assert (tested.returncode, tested.stderr) == (0, ""), said_by_tests(workspace)
    found = results(debian_colcon, workspace)
    linters = len(LINTERS) if planned.answers.tests == "ament" else 0
    assert found.pop("tests") >= linters + len(planned.answers.logics_in("python"))
    assert found == {"errors": 0, "failures": 0, "skipped": 0}


def said_by_tests(workspace: Path) -> str:
    return "\n".join(path.read_text() for path in workspace.glob("log/latest_test/*/stdout.log"))


@pytest.mark.network
def test_a_minimal_package_builds_and_its_test_passes(debian_colcon: Shell, workspace: Path) -> None:
    write(plan(nodes=("talker@/chatter",), minimal=True), workspace)
    built = debian_colcon.run("colcon", "build", cwd=workspace)
    assert (built.returncode, built.stderr) == (0, "")
    assert debian_colcon.run("colcon", "test", cwd=workspace).returncode == 0
    found = results(debian_colcon, workspace)
    assert found.pop("tests") > 0
    assert found == {"errors": 0, "failures": 0, "skipped": 0}


@pytest.mark.parametrize("name", PLANS)
def test_catkin_pkg_has_no_warning(one_colcon: Shell, workspace: Path, name: str) -> None:
    folder = write(PLANS[name](), workspace)
    code = (
        "import sys; from catkin_pkg.package import parse_package\n"
        "warnings = []; parse_package(sys.argv[1], warnings=warnings).validate(warnings=warnings)\n"
        "print(warnings)"
    )
    said = one_colcon.run("python", "-W", "error", "-c", code, folder / "package.xml", cwd=workspace)
    assert (said.stdout, said.stderr) == ("[]\n", "")


@pytest.mark.debian
@pytest.mark.parametrize(("name", "place"), [*((name, "git root") for name in PLANS), ("least", "plain folder")])
def test_every_linter_of_ament_is_content(shell: Shell, workspace: Path, name: str, place: str) -> None:
    """In plain folders they run as tests of the packages, above; only the least package has none."""
    folder = write(PLANS[name](), workspace)
    if place == "git root":
        assert shell.run("git", "init", "--quiet", cwd=folder).returncode == 0
    linted(shell, folder, LINTERS)


@pytest.mark.debian
@pytest.mark.parametrize("license", [each.spdx for each in LICENSES if each.header_known])
def test_ament_copyright_knows_every_license(shell: Shell, workspace: Path, license: str) -> None:
    folder = write(plan(license=license), workspace)
    assert shell.run("git", "init", "--quiet", cwd=folder).returncode == 0
    said = shell.run("/usr/bin/python3", "/usr/bin/ament_copyright", "--verbose", cwd=folder)
    assert said.returncode == 0, said.stdout + said.stderr
    assert "unknown>" not in said.stdout.replace("copyright=<unknown>", "")
    assert {"LICENSE", "CONTRIBUTING.md"} <= {line.partition(":")[0] for line in said.stdout.splitlines()}


@pytest.mark.debian
@pytest.mark.parametrize("license", [each.spdx for each in LICENSES if not each.header_known])
def test_ament_copyright_really_does_not_know_the_others(shell: Shell, workspace: Path, license: str) -> None:
    folder = write(plan(license=license), workspace)
    said = shell.run("/usr/bin/python3", "/usr/bin/ament_copyright", cwd=folder)
    assert said.returncode == 1
    assert "license=<unknown>" in said.stderr


@pytest.mark.network
def test_with_no_home_and_no_git_it_builds(one_colcon: Shell, workspace: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    from rospkg_cli.cli.new.run import new
    from rospkg_cli.scaffold.answers import Request

    monkeypatch.setenv("HOME", str(workspace / "nobody"))
    monkeypatch.setenv("PATH", str(workspace))
    monkeypatch.delenv("XDG_CONFIG_HOME", raising=False)
    assert new(Request("my_robot_nav"), workspace / "src") == 0
    monkeypatch.undo()
    built = one_colcon.run("colcon", "build", cwd=workspace)
    assert (built.returncode, built.stderr) == (0, "")
    shutil.rmtree(workspace)

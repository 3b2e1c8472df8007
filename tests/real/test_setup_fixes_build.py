"""What --fix makes of faulty packages, under real colcon: it builds, and `ros2 run` would find and start the nodes."""

from __future__ import annotations

import os
import sys
from pathlib import Path

import pytest
from broken_setups import BROKEN
from shell import Shell
from testing_new import STANDINS

SOURCE = Path(__file__).parents[2] / "src"


@pytest.fixture
def workspace(tmp_path: Path) -> Path:
    for name, broken in BROKEN.items():
        for path, text in broken.of(name).items():
            file = tmp_path / "ws" / "src" / name / path
            file.parent.mkdir(parents=True, exist_ok=True)
            file.write_text(text)
    return tmp_path / "ws"


def fix(shell: Shell, workspace: Path) -> None:
    options = ("--select", "SET", "--pedantic", "--fix", "--unsafe-fixes", "--fail-on", "info")
    said = shell.run(
        sys.executable, "-m", "rospkg_cli", "lint", *options, workspace, cwd=workspace, PYTHONPATH=str(SOURCE)
    )
    assert said.returncode == 0, said.stdout + said.stderr


@pytest.mark.network
@pytest.mark.parametrize("options", [(), ("--symlink-install",)], ids=["copied", "symlinked"])
def test_what_was_mended_is_built_found_and_started(
    one_colcon: Shell, workspace: Path, options: tuple[str, ...]
) -> None:
    fix(one_colcon, workspace)
    built = one_colcon.run("colcon", "build", *options, cwd=workspace)
    assert (built.returncode, built.stderr) == (0, "")
    for name in BROKEN:
        prefix = workspace / "install" / name
        assert (prefix / "share/ament_index/resource_index/packages" / name).is_file()
        assert (prefix / "share" / name / "package.xml").is_file()
        if name != "nothing_shared":
            assert (prefix / "share" / name / "launch/a.launch.xml").is_file(), name
        for node in ("talker", "listener"):
            program = prefix / "lib" / name / node
            assert os.access(program, os.X_OK), program
            assert "hello from rclpy" in started(one_colcon, prefix, workspace / "build" / name, program)


def started(shell: Shell, prefix: Path, build: Path, program: Path) -> str:
    """Return what a node says, with the paths that sourcing the workspace would set."""
    site = next(prefix.glob("lib/python3*/site-packages"))
    said = shell.run(program, cwd=prefix, PYTHONPATH=os.pathsep.join(map(str, (build, site, STANDINS))))
    assert said.returncode == 0, said.stderr
    return said.stdout


@pytest.mark.network
def test_without_the_fix_they_are_not_all_found(one_colcon: Shell, workspace: Path) -> None:
    """The other half of the proof: the faults are faults."""
    one_colcon.run("colcon", "build", "--continue-on-error", cwd=workspace)
    lost = {name for name in BROKEN if not os.access(workspace / "install" / name / "lib" / name / "talker", os.X_OK)}
    assert {"no_cfg", "other_cfg", "half_cfg", "joined", "lost_marker"} <= lost


@pytest.mark.network
def test_links_follow_install_scripts_where_develop_is_missing(colcon: Shell, workspace: Path) -> None:
    """SET002 is an info there: setuptools takes `install_scripts` for a `script_dir` that is not given."""
    package = workspace / "src" / "half_cfg"
    (package / "setup.cfg").write_text("[install]\ninstall_scripts=$base/lib/half_cfg\n")
    built = colcon.run("colcon", "build", "--symlink-install", "--packages-select", package.name, cwd=workspace)
    assert built.returncode == 0
    assert os.access(workspace / "install/half_cfg/lib/half_cfg/talker", os.X_OK)

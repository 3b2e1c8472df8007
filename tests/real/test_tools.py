"""The tools that the other tests stand on are what they say they are."""

from __future__ import annotations

from pathlib import Path

import pytest
from shell import Shell
from venvs import SETUPTOOLS

FOREIGN = ("PYTHONPATH", "PYTHONDONTWRITEBYTECODE", "ROS_DISTRO", "AMENT_PREFIX_PATH", "COLCON_HOME", "GIT_DIR")
PLUGINS = (
    "blind-except", "builtins", "class-newline", "comprehensions", "deprecated", "docstrings", "import-order",
    "quotes",
)  # fmt: skip


@pytest.fixture
def foreign_environment(monkeypatch: pytest.MonkeyPatch) -> None:
    for name in FOREIGN:
        monkeypatch.setenv(name, "/elsewhere")


def test_nothing_of_the_outer_environment_reaches_a_tool(
    foreign_environment: None, shell: Shell, tmp_path: Path
) -> None:
    said = shell.run("env", cwd=tmp_path).stdout
    assert "HOME=" in said
    assert "/elsewhere" not in said
    assert str(tmp_path) in shell.run("git", "config", "--show-origin", "user.name", cwd=tmp_path).stdout


def test_each_setuptools_is_there(colcon: Shell, tmp_path: Path) -> None:
    said = colcon.run("python", "-c", "import setuptools; print(setuptools.__version__)", cwd=tmp_path)
    assert said.stdout.strip() in SETUPTOOLS
    verbs = colcon.run("colcon", "--help", cwd=tmp_path).stdout
    assert [verb for verb in ("build", "test", "test-result") if verb not in verbs] == []


@pytest.mark.debian
def test_flake8_has_the_eight_plugins_of_ros(shell: Shell, tmp_path: Path) -> None:
    said = shell.run("/usr/bin/python3", "-m", "flake8", "--version", cwd=tmp_path).stdout.replace("-\n", "-")
    assert [name for name in PLUGINS if name not in said] == []


@pytest.mark.debian
def test_colcon_reaches_debians_ament(debian_colcon: Shell, tmp_path: Path) -> None:
    code = "import ament_copyright, ament_package, em; print(ament_copyright.__file__, em.__version__)"
    said = debian_colcon.run("python", "-c", code, cwd=tmp_path).stdout.split()
    assert said[0].startswith("/usr/lib/python3/dist-packages/")
    assert said[1].startswith("3.")

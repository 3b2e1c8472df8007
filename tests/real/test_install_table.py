"""The install table against what colcon really installs, with each setuptools."""

from __future__ import annotations

import json
import re
import sys
from pathlib import Path

import pytest
from odd_packages import ODD
from shell import Shell
from testing_new import plan, write

COLCONS_OWN = re.compile(
    r"share/[^/]+/(?:package\.(?:sh|bash|zsh|ps1|dsv)|hook/.*)|share/colcon-core/.*|.*\.egg-info/.*|.*\.egg-info|"
    r".*/__pycache__/.*|.*\.pyc"
)
"""Files that colcon and setuptools add to whatever a package installs."""

PYTHON = re.compile(r"lib/python3\.\d+/site-packages/")


def installed(prefix: Path) -> set[str]:
    """Return what stands below a prefix, in the terms of `rospkg inspect`."""
    files = {path.relative_to(prefix).as_posix() for path in prefix.rglob("*") if not path.is_dir()}
    return {PYTHON.sub("lib/python3.*/site-packages/", path) for path in files if not COLCONS_OWN.fullmatch(path)}


def inspected(shell: Shell, workspace: Path) -> dict[str, set[str]]:
    """Return what `rospkg inspect` says, by package."""
    source = str(Path(__file__).parents[2] / "src")
    said = shell.run(
        sys.executable, "-m", "rospkg_cli", "inspect", "--format", "json", workspace, cwd=workspace, PYTHONPATH=source
    )
    assert (said.returncode, said.stderr) == (0, "")
    packages = json.loads(said.stdout)["packages"]
    assert [package["unknown"] for package in packages] == [[]] * len(packages)
    return {package["name"]: {row["destination"] for row in package["installed"]} for package in packages}


@pytest.mark.network
def test_the_table_is_what_colcon_installs(colcon: Shell, tmp_path: Path) -> None:
    workspace = tmp_path / "ws"
    write(plan(nodes=("talker", "listener")), workspace)
    for name, files in ODD.items():
        for path, text in files.items():
            file = workspace / "src" / name / path
            file.parent.mkdir(parents=True, exist_ok=True)
            file.write_text(text)
            file.chmod(0o755 if text.startswith("#!") else 0o644)
    expected = inspected(colcon, workspace)
    built = colcon.run("colcon", "build", cwd=workspace)
    assert built.returncode == 0, built.stderr
    assert set(expected) == {"my_robot_nav", *ODD}
    assert {name: installed(workspace / "install" / name) for name in expected} == expected

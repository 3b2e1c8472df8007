"""What `action.yml` runs, as a runner would run it."""

from __future__ import annotations

import json
import sys
from pathlib import Path

import pytest
import yaml
from absent import absent
from checkout import ROOT, copy_checkout
from shell import Shell
from small_rosdistro import FILES
from venvs import NoIndexError, venv

from rospkg_cli.example import Example


@pytest.fixture
def workspace(tmp_path: Path) -> Path:
    files = Example(bad={}, good={}).bad_files()
    files["package.xml"] = files["package.xml"].replace("Apache-2.0", "TODO")
    for path, text in files.items():
        (tmp_path / "ws/my_pkg" / path).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / "ws/my_pkg" / path).write_text(text)
    return tmp_path / "ws"


def test_it_annotates_reports_and_sums_up(workspace: Path, tmp_path: Path, shell: Shell) -> None:
    try:
        venv(sys.executable, ("hatchling",))
    except NoIndexError as error:
        absent(str(error))
    (step,) = yaml.safe_load((ROOT / "action.yml").read_text())["runs"]["steps"]
    assert step["run"] == 'bash "$ROSPKG/.ci/action"'
    variables = {
        "ROSPKG": str(copy_checkout(tmp_path / "checkout")),
        "ROSPKG_PATHS": ".",
        "ROSPKG_ARGS": "--fail-on warning",
        "ROSPKG_SARIF": "out.sarif",
        "ROSPKG_INDEX": "false",
        "HOME": str(tmp_path / "runner"),
        "RUNNER_TEMP": str(tmp_path / "runner"),
        "GITHUB_STEP_SUMMARY": str(tmp_path / "summary.md"),
        "PATH": f"{Path(sys.executable).parent}:{shell.variables['PATH']}",
    }
    assert set(step["env"]) == {name for name in variables if name.startswith("ROSPKG")}
    for path, text in FILES.items():
        (tmp_path / "rosdistro" / path).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / "rosdistro" / path).write_text(text)
    variables["ROSPKG_INDEX"] = str(tmp_path / "rosdistro")
    done = shell.run("bash", "-c", step["run"], cwd=workspace, **variables)
    assert done.returncode == 1, done.stdout + done.stderr
    assert (Path(variables["HOME"]) / ".cache/rospkg/index.txt").is_file()
    assert done.stdout.startswith("::warning file=my_pkg/package.xml,line=8,")
    assert json.loads((workspace / "out.sarif").read_text())["version"] == "2.1.0"
    assert "| warning | XML104 placeholder-metadata |" in (tmp_path / "summary.md").read_text()

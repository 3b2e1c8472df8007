"""What a release needs: one version, a workflow that publishes only what was tested, and the commands that it runs."""

from __future__ import annotations

import re
import subprocess
from pathlib import Path

import yaml
from in_process import run_here

from rospkg_cli import __version__

ROOT = Path(__file__).parents[1]
JOBS = yaml.safe_load((ROOT / ".github/workflows/release.yml").read_text(encoding="utf-8"))["jobs"]


def script(job: str) -> str:
    return "\n".join(step.get("run", "") for step in JOBS[job]["steps"])


def test_the_version_stands_in_one_place(tmp_path: Path) -> None:
    assert run_here("--version", cwd=tmp_path).stdout.split()[-1] == __version__
    pyproject = (ROOT / "pyproject.toml").read_text(encoding="utf-8")
    assert 'dynamic = ["version"]' in pyproject
    assert f"## {__version__} " in (ROOT / "CHANGELOG.md").read_text(encoding="utf-8")


def test_only_what_was_tested_is_published() -> None:
    assert set(JOBS["publish"]["needs"]) == set(JOBS) - {"publish"}
    assert [name for name, job in JOBS.items() if "id-token" in job.get("permissions", {})] == ["publish"]
    assert not re.search(r"secrets\.|password", str(JOBS))


def test_every_supported_python_is_tested() -> None:
    pythons = JOBS["test"]["strategy"]["matrix"]["python"]
    lowest = re.search(r'requires-python = ">=(.*)"', (ROOT / "pyproject.toml").read_text(encoding="utf-8"))
    assert lowest
    assert pythons[0] == lowest[1]
    assert set(JOBS["install"]["strategy"]["matrix"]["python"]) == {pythons[0], pythons[-1]}


def test_what_it_tries_after_installing_runs(tmp_path: Path) -> None:
    commands = re.findall(r"^rospkg (.*)$", script("install"), re.MULTILINE)
    assert len(commands) == 3
    for command in commands:
        assert run_here(*command.split(), cwd=tmp_path).returncode == 0, command


def test_the_changelog_has_a_date_before_it_is_published(tmp_path: Path) -> None:
    check = script("build").partition("test -f")[2].partition("\n")[2]
    for heading, passes in (("## 0.1.0 (2026-12-01)", True), ("## 0.1.0 (unreleased)", False)):
        (tmp_path / "CHANGELOG.md").write_text(f"{heading}\n")
        done = subprocess.run(["bash", "-c", f"version=0.1.0\n{check}"], cwd=tmp_path, capture_output=True)
        assert (done.returncode == 0) is passes

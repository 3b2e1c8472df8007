"""Command lines that can't be understood: one sentence, what was meant, where help is; and counts for machines."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from in_process import run_here as rospkg


@pytest.mark.parametrize(
    "typed, says",
    [
        ("lint --confg x", "there is no option `--confg` (did you mean `--config`?); `rospkg lint --help` shows how"),
        ("lint --nonsense", "there is no option `--nonsense`; `rospkg lint --help` shows how"),
        ("format --config x", "there is no option `--config`; `rospkg format --help` shows how"),
        ("init", "there is no command `init` (did you mean `rospkg new`?); `rospkg --help` shows how"),
        ("check .", "there is no command `check` (did you mean `rospkg lint`?); `rospkg --help` shows how"),
        ("fix", "there is no command `fix` (did you mean `rospkg lint --fix`?); `rospkg --help` shows how"),
        ("rulez", "there is no command `rulez` (did you mean `rospkg rules`?); `rospkg --help` shows how"),
        ("indx", "there is no command `indx` (did you mean `rospkg index`?); `rospkg --help` shows how"),
        ("xyz", "there is no command `xyz`; `rospkg --help` shows how"),
        ("lint --target", "option '--target' requires an argument; `rospkg lint --help` shows how"),
        (
            "lint --select DEP101 DEP102",
            "`DEP102` is a rule, and stands where a path belongs; join rules by commas: --select A,B",
        ),
        ("lint DEP", "`DEP` is a rule, and stands where a path belongs; join rules by commas: --select A,B"),
        (
            "lint --statistics --format sarif",
            "--statistics is printed as text or json, not as `sarif`; give --format text or json",
        ),
    ],
)
def test_what_is_said(tmp_path: Path, typed: str, says: str) -> None:
    done = rospkg(*typed.split(), cwd=tmp_path)
    assert (done.returncode, done.stdout, done.stderr) == (2, "", f"rospkg: {says}\n")


def test_a_path_that_has_the_name_of_a_rule_is_a_path(tmp_path: Path) -> None:
    (tmp_path / "DEP").mkdir()
    assert "RPK006" in rospkg("lint", "DEP", cwd=tmp_path).stdout


def test_a_path_outside_is_shown_as_it_leads_there(tmp_path: Path) -> None:
    (tmp_path / "here").mkdir()
    (tmp_path / "there").mkdir()
    done = rospkg("lint", tmp_path / "there", "--format", "concise", cwd=tmp_path / "here")
    assert done.stdout.startswith("../there:1:1: error RPK006")
    assert f"`{tmp_path}/there`" in done.stdout
    assert rospkg("lint", "--format", "concise", cwd=tmp_path).stdout.startswith(".:1:1: error RPK006")


def test_statistics_as_json(tmp_path: Path, write, clean) -> None:
    text = (
        clean["package.xml"]
        .replace("Apache-2.0", "TODO")
        .replace("  <name>", "  <!-- rospkg: ignore[XML104] x -->\n  <name>")
    )
    write(tmp_path, {**clean, "package.xml": text})
    done = rospkg("lint", "--statistics", "--format", "json", "--select", "XML104,RPK002", cwd=tmp_path)
    assert done.returncode == 1
    counts = {"count": 1, "errors": 0, "warnings": 1, "infos": 0}
    assert json.loads(done.stdout) == [
        {"code": "RPK002", "name": "unused-suppression", **counts, "fixable": 1},
        {"code": "XML104", "name": "placeholder-metadata", **counts, "fixable": 0},
    ]


def test_a_traceback_may_be_asked_for_before_the_verb(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def raises(*_: object) -> int:
        raise RuntimeError("boom")

    monkeypatch.setattr("rospkg_cli.cli.lint.run.lint", raises)
    for typed in (["--traceback", "lint"], ["lint", "--traceback"]):
        assert "Traceback" in rospkg(*typed, cwd=tmp_path).stderr
    said = rospkg("lint", cwd=tmp_path).stderr
    assert said == "rospkg: internal error: RuntimeError: boom; please report it with the output of --traceback\n"

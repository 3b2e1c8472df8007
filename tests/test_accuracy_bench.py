"""The bench of accuracy: which findings are new against another state of lint, and how many of a rule are drawn."""

from __future__ import annotations

import sys
from pathlib import Path
from random import Random
from typing import Any

import pytest

sys.path.insert(0, str(Path(__file__).parents[1]))

from bench.accuracy import new
from bench.accuracy.reports import Report


def finding(code: str, line: int, severity: str = "warning") -> dict[str, Any]:
    return {"code": code, "path": "setup.py", "line": line, "severity": severity}


@pytest.fixture
def two_states(monkeypatch: pytest.MonkeyPatch) -> None:
    before = (finding("SET101", 1), finding("SET102", 2, "info"))
    now = (*(finding("SET101", line) for line in range(1, 9)), finding("SET102", 2), finding("SET103", 3, "info"))

    def lint(repository: Path, options: list[str], python: str = "") -> Report:
        if "broken" in repository.name and python:
            raise RuntimeError("exit 3")
        return Report(repository, 1, before if python else now)

    monkeypatch.setattr(new, "lint", lint)


@pytest.mark.usefixtures("two_states")
def test_what_is_new_is_drawn_a_few_of_each_rule() -> None:
    (report,) = new.new_reports([Path("a")], "python", [], 3, 1)
    codes = [each["code"] for each in report.findings]
    assert codes == ["SET101"] * 3 + ["SET102"]
    assert all(each["line"] > 1 for each in report.findings)


@pytest.mark.usefixtures("two_states")
def test_a_repository_where_the_other_state_crashes_is_left_out(capsys: pytest.CaptureFixture[str]) -> None:
    assert list(new.new_reports([Path("broken")], "python", [], 3, 1)) == []
    assert "exit 3" in capsys.readouterr().err


def test_few_are_all_drawn() -> None:
    few = [finding("SET101", 1), finding("SET101", 2)]
    assert list(new.drawn(few, 5, Random(1))) == few

"""An info that several packages share is one finding of a report; errors and warnings are told one by one."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest
from in_process import run_here

from rospkg_cli.example import CMAKE, manifest
from rospkg_cli.finding import Finding, Location, Severity
from rospkg_cli.report.shared_infos import with_shared_infos
from rospkg_cli.source import Span


@pytest.fixture
def workspace(tmp_path: Path) -> Path:
    """Three packages that ask for CMake 3.5, 3.8 and 3.5."""
    for name, version in (("a_pkg", "3.5"), ("b_pkg", "3.8"), ("c_pkg", "3.5")):
        (tmp_path / name).mkdir()
        (tmp_path / name / "package.xml").write_text(manifest("", "ament_cmake", name))
        (tmp_path / name / "CMakeLists.txt").write_text(CMAKE.replace("my_pkg", name).replace("3.20", version))
    return tmp_path


def told(folder: Path, *options: str, code: str = "CMK002") -> list[dict[str, Any]]:
    result = run_here("lint", folder, "--select", code, "--format", "json", "--no-cache", *options, cwd=folder)
    found: list[dict[str, Any]] = json.loads(result.stdout)["findings"]
    return found


def test_an_info_of_several_packages_is_told_once(workspace: Path) -> None:
    (finding,) = told(workspace)
    assert finding["path"].endswith("a_pkg/CMakeLists.txt")
    assert [(Path(each["path"]).parent.name, each["message"]) for each in finding["related"]] == [
        ("b_pkg", "and here"),
        ("c_pkg", "and here"),
    ]


def test_descriptions_that_repeat_the_name_are_told_once(workspace: Path) -> None:
    for path in workspace.glob("*/package.xml"):
        path.write_text(path.read_text().replace("Drives my robot", f"The {path.parent.name} package"))
    (finding,) = told(workspace, code="XML104")
    assert len(finding["related"]) == 2


def test_each_warning_is_told(workspace: Path) -> None:
    assert [len(each["related"]) for each in told(workspace, "--target", "lyrical")] == [0, 0, 0]


def test_infos_of_one_package_stay_apart(workspace: Path) -> None:
    assert len(told(workspace / "a_pkg")) == 1


def test_all_of_them_are_in_a_baseline(workspace: Path) -> None:
    baseline = workspace / "baseline.json"
    run_here("lint", workspace, "--select", "CMK002", "--no-cache", "--write-baseline", baseline, cwd=workspace)
    assert len(json.loads(baseline.read_text())["findings"]) == 3
    assert told(workspace, "--baseline", str(baseline)) == []


def info(package: str, line: int, message: str = "old (3.5)", severity: Severity = Severity.INFO) -> Finding:
    at = Location(f"{package}/CMakeLists.txt", Span(0, 1), line, 1, line, 2)
    return Finding("CMK002", "old-cmake-minimum", severity, message, at, package)


@pytest.mark.parametrize(
    "found, lines",
    [
        ([info("a", 1), info("b", 2)], {1: [2]}),
        ([info("a", 1), info("a", 2)], {1: [], 2: []}),
        ([info("a", 1), info("a", 2), info("b", 3)], {1: [2, 3]}),
        ([info("a", 1), info("b", 2, "old (3.8)"), info("c", 3, "older (3.5)")], {1: [2], 3: []}),
        ([info("a", 1, severity=Severity.WARNING), info("b", 2, severity=Severity.WARNING)], {1: [], 2: []}),
        ([info("a", 1), info("b", 2, severity=Severity.WARNING), info("c", 3)], {1: [3], 2: []}),
    ],
)
def test_what_is_told_at_another_place(found: list[Finding], lines: dict[int, list[int]]) -> None:
    told = with_shared_infos(found)
    assert {each.location.line: [at.line for at, _ in each.related] for each in told} == lines
    assert {text for each in told for _, text in each.related} <= {"and here"}

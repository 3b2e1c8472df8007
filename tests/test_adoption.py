"""Baselines, statistics, --add-ignores, preview, required-version: how rospkg comes into a large workspace."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from in_process import run_here as rospkg
from test_lint_command import TODO

from rospkg_cli.config.required_version import satisfies
from rospkg_cli.engine.baseline import apply_baseline, keys
from rospkg_cli.engine.selection import Selection
from rospkg_cli.finding import Severity
from rospkg_cli.light_dataclasses import replace
from rospkg_cli.package.manifest import Manifest
from rospkg_cli.rule import Rule
from rospkg_cli.testing import lint_files


@pytest.fixture
def package(tmp_path, write, clean) -> Path:
    manifest = clean["package.xml"].replace("Apache-2.0", TODO)
    return write(tmp_path / "ws" / "my_pkg", {**clean, "package.xml": manifest})


def test_a_baseline_holds_when_lines_move_and_shows_what_is_new(package: Path) -> None:
    assert rospkg("lint", "--write-baseline", "known.json", cwd=package).returncode == 0
    assert rospkg("lint", "--baseline", "known.json", cwd=package).returncode == 0
    manifest = package / "package.xml"
    manifest.write_text(manifest.read_text().replace("  <name>", "\n\n  <name>"))
    done = rospkg("lint", "--baseline", package / "known.json", cwd=package.parent)
    assert done.returncode == 0
    assert "1 in the baseline" in done.stdout
    manifest.write_text(manifest.read_text().replace("  <license>", "  <!-- x --><license>TODO</license>\n  <license>"))
    again = rospkg("lint", "--baseline", "known.json", "--format", "json", cwd=package)
    assert again.returncode == 1
    assert ["TODO" in f["message"] for f in json.loads(again.stdout)["findings"]] == [True]
    assert "description" not in json.loads(again.stdout)["findings"][0]["message"]


def test_a_baseline_sets_each_finding_aside_as_often_as_it_counts_it(clean: dict[str, str]) -> None:
    text = clean["package.xml"].replace("Apache-2.0", TODO)
    results = lint_files({**clean, "package.xml": text}, ["XML104"])
    known = keys(results.findings, str)
    before = apply_baseline(results, known, str)
    assert [(each.suppressed, each.external) for each in before.suppressed] == [("in the baseline", True)]
    twice = apply_baseline(replace(results, findings=results.findings * 2), known, str)
    assert (len(twice.findings), len(twice.suppressed)) == (1, 1)


def test_a_missing_or_foreign_baseline_is_said(package: Path) -> None:
    missing = rospkg("lint", "--baseline", "none.json", cwd=package)
    assert (missing.returncode, "--write-baseline none.json" in missing.stderr) == (2, True)
    (package / "other.json").write_text("[]")
    assert "is not a baseline" in rospkg("lint", "--baseline", "other.json", cwd=package).stderr


def test_statistics_count_by_rule(package: Path) -> None:
    done = rospkg("lint", "--statistics", cwd=package)
    assert done.returncode == 1
    assert done.stdout.splitlines()[0].split() == ["1", "XML104", "placeholder-metadata"]


def test_add_ignores_silences_with_a_reason(package: Path) -> None:
    done = rospkg("lint", "--add-ignores", "it will -- come", cwd=package)
    assert done.returncode == 0, done.stderr
    text = (package / "package.xml").read_text()
    assert "  <!-- rospkg: ignore[XML104] it will – come -->\n  <license>" in text
    assert rospkg("lint", cwd=package).returncode == 0
    assert rospkg("lint", "--add-ignores", "again", cwd=package).returncode == 0
    assert (package / "package.xml").read_text() == text


def test_add_ignores_wants_a_reason(package: Path) -> None:
    assert "requires a reason" in rospkg("lint", "--add-ignores", " ", cwd=package).stderr


def test_add_ignores_in_every_kind_of_comment(tmp_path, write, clean) -> None:
    include = {"include/my_pkg/a.hpp": "#include <sensor_msgs/msg/imu.hpp>\n"}
    cmake = (
        "cmake_minimum_required(VERSION 3.20)\nproject(my_pkg)\nfind_package(ament_cmake REQUIRED)\nament_package()\n"
    )
    manifest = clean["package.xml"].replace("ament_python", "ament_cmake")
    package = write(tmp_path / "my_pkg", {"package.xml": manifest, "CMakeLists.txt": cmake, **include})
    select = ("--select", "DEP,XML208")
    assert rospkg("lint", *select, cwd=package).returncode == 1
    assert rospkg("lint", *select, "--add-ignores", "in time", cwd=package).returncode == 0
    assert (package / "include/my_pkg/a.hpp").read_text().startswith("// rospkg: ignore[DEP105] in time\n#include")
    assert rospkg("lint", *select, cwd=package).returncode == 0


@pytest.mark.parametrize("option", [("--add-ignores", "x"), ("--write-baseline", "known.json")])
def test_where_nothing_was_checked_nothing_is_silenced(tmp_path: Path, option: tuple[str, str]) -> None:
    done = rospkg("lint", *option, cwd=tmp_path)
    assert (done.returncode, "RPK006" in done.stdout, list(tmp_path.iterdir())) == (2, True, [])


def test_a_new_rule_runs_only_in_preview() -> None:
    rule = Rule("XML999", "new-one", Manifest, Severity.ERROR, lambda _: iter(()), preview=True)
    assert not Selection().runs(rule)
    assert Selection(preview=True).runs(rule)
    assert Selection(select=("XML999",)).runs(rule)


@pytest.mark.parametrize(
    "wanted, holds",
    [(">=0.1", True), ("0.1.0", True), (">0.1", False), (">=0.1,<0.2", True), ("!=0.1", False), ("<=0.1.0", True)],
)
def test_required_version(wanted: str, holds: bool) -> None:
    assert satisfies("0.1.0", wanted) is holds


def test_a_version_that_does_not_fit_stops_the_run(package: Path) -> None:
    (package.parent / "rospkg.toml").write_text('required-version = ">=99"\n')
    done = rospkg("lint", cwd=package)
    assert done.returncode == 2
    assert "requires rospkg >=99" in done.stderr
    (package.parent / "rospkg.toml").write_text('required-version = "newest"\n')
    assert "is no requirement" in rospkg("lint", cwd=package).stderr

"""`--fix` leaves infos alone unless they are asked for."""

from __future__ import annotations

from pathlib import Path

import pytest
from in_process import run_here

from rospkg_cli.example import BACKDROPS, existing_files, manifest

INFO, WARNING = "import std_msgs.msg\n", "import cv2\n"


@pytest.fixture
def package(tmp_path: Path) -> Path:
    (tmp_path / ".git").mkdir()  # else the packages of the other tests are beside it
    files = existing_files(BACKDROPS["ament_python"])
    files |= {"package.xml": manifest("  <exec_depend>sensor_msgs</exec_depend>\n"), "my_pkg/a.py": INFO + WARNING}
    for path, text in files.items():
        (tmp_path / path).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / path).write_text(text, encoding="utf-8")
    return tmp_path


@pytest.mark.parametrize(
    "options, names",
    [
        ([], {"python3-opencv"}),
        (["--fix-level", "warning"], {"python3-opencv"}),
        (["--fix-level", "error"], set()),
        (["--fix-level", "info"], {"python3-opencv", "std_msgs"}),
        (["--show", "info"], {"python3-opencv", "std_msgs"}),
        (["--show", "all"], {"python3-opencv", "std_msgs"}),
        (["--show", "info", "--fix-level", "warning"], {"python3-opencv"}),
        (["--fail-on", "info"], {"python3-opencv", "std_msgs"}),
        (["--select", "DEP101"], {"python3-opencv", "std_msgs"}),
    ],
)
def test_what_is_fixed(package: Path, options: list[str], names: set[str]) -> None:
    run_here("lint", "--fix", *options, cwd=package)
    text = (package / "package.xml").read_text(encoding="utf-8")
    assert {name for name in ("python3-opencv", "std_msgs") if name in text} == names


def test_a_level_is_one_of_three(package: Path) -> None:
    assert (
        "--fix-level must be one of error, warning, info" in run_here("lint", "--fix-level", "all", cwd=package).stderr
    )


def test_the_summary_says_which_option_fixes_what(package: Path) -> None:
    said = run_here("lint", "--show", "info", cwd=package).stdout
    assert "1 fixable with --fix. 1 info fixable with --fix --fix-level info." in said
    assert "--fix --fix-level info: declare `std_msgs`" in said
    assert "1 fixable with --fix)" in run_here("lint", "--statistics", cwd=package).stdout

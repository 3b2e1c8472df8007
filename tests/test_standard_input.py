"""`rospkg lint - --stdin-filename FILE`: the text of an editor in place of a file."""

from __future__ import annotations

import io
import sys
from pathlib import Path

import pytest
from in_process import Done, run_here
from writing import Write


@pytest.fixture
def package(tmp_path: Path, write: Write, clean: dict[str, str]) -> Path:
    return write(tmp_path / "ws/my_pkg", clean)


def lint(monkeypatch: pytest.MonkeyPatch, text: str | bytes, cwd: Path, *arguments: str) -> Done:
    data = text.encode() if isinstance(text, str) else text
    monkeypatch.setattr(sys, "stdin", io.TextIOWrapper(io.BytesIO(data)))
    return run_here("lint", *arguments, "--format", "concise", cwd=cwd)


def test_the_text_counts_and_not_the_file(package: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    text = (package / "package.xml").read_text().replace("Apache-2.0", "TODO")
    done = lint(monkeypatch, text, package, "-", "--stdin-filename", "package.xml")
    assert (done.returncode, done.stderr) == (1, "")
    assert done.stdout.splitlines()[0].startswith("package.xml:8:12: warning XML104 ")
    assert "TODO" not in (package / "package.xml").read_text()


def test_a_clean_text_has_status_0(package: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (package / "package.xml").write_text((package / "package.xml").read_text().replace("Apache-2.0", "TODO"))
    text = (package / "package.xml").read_text().replace("TODO", "Apache-2.0")
    assert lint(monkeypatch, text, package, "-", "--stdin-filename", "package.xml").returncode == 0


def test_findings_in_other_files_are_not_told(package: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (package / "package.xml").write_text((package / "package.xml").read_text().replace("Apache-2.0", "TODO"))
    done = lint(monkeypatch, "import rclpy\n", package, "-", "--stdin-filename", "my_pkg/new.py")
    assert [line.split()[2] for line in done.stdout.splitlines() if ": " in line] == ["DEP101"]


def test_a_file_of_no_package_is_none_of_ours(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """An editor gives every file of a kind."""
    done = lint(monkeypatch, "a: [", tmp_path, "-", "--stdin-filename", "ci.yml")
    assert (done.returncode, done.stdout) == (0, "")


def test_the_dash_may_be_left_out(package: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    done = lint(monkeypatch, "import rclpy\n", package.parent, "--stdin-filename", "my_pkg/my_pkg/new.py")
    assert "DEP101" in done.stdout


def test_it_is_read_anew_each_time(package: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "cache"))
    arguments = ("-", "--stdin-filename", "my_pkg/new.py")
    assert "DEP101" in lint(monkeypatch, "import rclpy\n", package, *arguments).stdout
    assert "DEP101" not in lint(monkeypatch, "import os\n", package, *arguments).stdout


@pytest.mark.parametrize(
    "arguments, says",
    [
        (("-",), "`-` is standard input; --stdin-filename says which file it stands for"),
        (
            ("my_pkg", "--stdin-filename", "setup.py"),
            "--stdin-filename is for one file; leave the paths out, or give `-`",
        ),
        (
            ("-", "--stdin-filename", "setup.py", "--fix"),
            "--fix can't be used with standard input, which is no file on disk",
        ),
        (
            ("-", "--stdin-filename", "setup.py", "--add-ignores", "x"),
            "--add-ignores can't be used with standard input, which is no file on disk",
        ),
        (("-", "--stdin-filename", "nowhere/setup.py"), "--stdin-filename: there is no folder `nowhere`"),
    ],
)
def test_wrong_use(package: Path, monkeypatch: pytest.MonkeyPatch, arguments: tuple[str, ...], says: str) -> None:
    done = lint(monkeypatch, "", package, *arguments)
    assert (done.returncode, done.stdout, done.stderr) == (2, "", f"rospkg: {says}\n")


def test_too_much_is_refused(package: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    done = lint(monkeypatch, b"#" * 4_000_001, package, "-", "--stdin-filename", "setup.py")
    assert (done.returncode, done.stderr) == (2, "rospkg: standard input has more than the limit of 4 MB\n")

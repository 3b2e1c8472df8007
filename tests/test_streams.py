"""Standard streams that are closed, full, unread, or of a poor encoding: the right status, and one sentence."""

from __future__ import annotations

import os
import subprocess
import sys
from collections.abc import Mapping
from pathlib import Path

import pytest

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="there is no /dev/full")
FULL = "rospkg: can't write to standard output: No space left on device\n"
needs_full = pytest.mark.skipif(not Path("/dev/full").exists(), reason="there is no /dev/full")

VERBS = {
    "lint": (1, "lint my_pkg"),
    "json": (1, "lint my_pkg --format json"),
    "diff": (1, "lint my_pkg --diff --fix-level info"),
    "inspect": (0, "inspect my_pkg"),
    "graph": (0, "graph my_pkg"),
    "doctor": (0, "doctor my_pkg"),
    "format": (1, "format my_pkg --diff"),
    "check": (1, "format my_pkg --check"),
    "explain": (0, "explain SET101"),
    "rules": (0, "rules"),
    "status": (0, "index status"),
    "new": (0, "new my_new --dry-run --maintainer A --email a@b.example"),
    "version": (0, "--version"),
    "help": (0, "lint --help"),
}
FEW = ("lint", "format", "version")


@pytest.fixture
def folder(tmp_path: Path, clean: dict[str, str], write) -> Path:
    """A package with a fault that `--fix` and `format` mend."""
    text = clean["package.xml"]
    text = text.replace("  <license>", "  <author>A</author>\n  <license>").replace("Apache-2.0", "TODO")
    write(tmp_path / "my_pkg", {**clean, "package.xml": text})
    return tmp_path


def run(folder: Path, verb: str, after: str = "", **more: str) -> subprocess.CompletedProcess[bytes]:
    """Run a verb by a shell, with its streams as `after` says."""
    command = f'"{sys.executable}" -m rospkg_cli {verb} {after}'
    return subprocess.run(["bash", "-c", command], cwd=folder, capture_output=True, env=environment(more), timeout=60)


def environment(more: Mapping[str, str]) -> dict[str, str]:
    kept = {
        key: value for key, value in os.environ.items() if not key.startswith(("PYTHONIO", "PYTHONUN", "LC_", "LANG"))
    }
    return {**kept, "XDG_CACHE_HOME": os.devnull, "COLUMNS": "80", **more}


@pytest.mark.parametrize("name", VERBS)
def test_a_closed_stdout_is_heard_by_nobody(folder: Path, name: str) -> None:
    status, verb = VERBS[name]
    done = run(folder, verb, ">&-")
    assert (done.returncode, done.stdout) == (status, b"")
    assert b"Error" not in done.stderr
    assert b"fault" not in done.stderr


@pytest.mark.parametrize("name", FEW)
def test_a_closed_stderr_changes_nothing(folder: Path, name: str) -> None:
    status, verb = VERBS[name]
    usual, done = run(folder, verb), run(folder, verb, "2>&-")
    assert (done.returncode, done.stdout, done.stderr) == (status, usual.stdout, b"")


@pytest.mark.parametrize("name", FEW)
def test_all_streams_may_be_closed(folder: Path, name: str) -> None:
    status, verb = VERBS[name]
    assert run(folder, verb, "<&- >&- 2>&-").returncode == status


@needs_full
@pytest.mark.parametrize("name", VERBS)
def test_a_full_disk_is_the_disks_fault(folder: Path, name: str) -> None:
    _, verb = VERBS[name]
    done = run(folder, verb, "> /dev/full")
    assert (done.returncode, done.stderr.decode().count("can't write")) == (2, 1)
    assert done.stderr.decode().endswith(FULL)
    assert b"ignored in" not in done.stderr
    assert b"fault" not in done.stderr


@needs_full
@pytest.mark.parametrize("name", FEW)
def test_a_full_stderr_changes_nothing(folder: Path, name: str) -> None:
    status, verb = VERBS[name]
    usual, done = run(folder, verb), run(folder, verb, "2> /dev/full")
    assert (done.returncode, done.stdout) == (status, usual.stdout)
    assert run(folder, verb, "> /dev/full 2> /dev/full").returncode == 2


@needs_full
def test_an_error_that_nobody_hears_keeps_its_status(folder: Path) -> None:
    for after in ("2> /dev/full", "2>&-"):
        assert run(folder, "lint nowhere", after).returncode == 2
        assert run(folder, "nonsense", after).returncode == 2


def test_a_pipe_that_is_gone_is_status_141(folder: Path) -> None:
    for name in ("rules", "lint", "version", "help"):
        reading, writing = os.pipe()
        os.close(reading)
        command = [sys.executable, "-m", "rospkg_cli", *VERBS[name][1].split()]
        done = subprocess.run(command, cwd=folder, stdout=writing, stderr=subprocess.PIPE, env=environment({}))
        os.close(writing)
        assert (done.returncode, done.stderr) == (141, b""), name


@needs_full
def test_what_is_written_is_no_failure(folder: Path) -> None:
    """The package is there, whoever hears of it."""
    new = "new {} --maintainer A --email a@b.example"
    done = run(folder, new.format("my_a"), "> /dev/full")
    assert (done.returncode, (folder / "my_a/package.xml").exists()) == (0, True)
    assert done.stderr.decode() == FULL.replace("\n", "; the package is written\n")
    for number, after in enumerate((">&-", "> /dev/full 2> /dev/full")):
        assert run(folder, new.format(f"my_b{number}x"), after).returncode == 0
        assert (folder / f"my_b{number}x/package.xml").exists()
    done = run(folder, new.format("my_robot") + " --family", "> /dev/full")
    assert (done.returncode, done.stderr.decode()) == (0, FULL.replace("\n", "; the packages are written\n"))


POOR = [{"PYTHONIOENCODING": "cp1252:strict"}, {"LC_ALL": "C", "PYTHONUTF8": "0"}]


@pytest.mark.parametrize("poor", POOR, ids=lambda poor: "-".join(poor.values()))
def test_a_poor_encoding_is_no_fault(folder: Path, poor: dict[str, str]) -> None:
    manifest = folder / "my_pkg/package.xml"
    manifest.write_text(manifest.read_text("utf-8").replace("TODO", "TODO: é机器人 \U0001f916"), "utf-8")
    (folder / "my_pkg/机器人.xml.in").write_text("x")
    for name in ("lint", "diff", "inspect", "explain", "help"):
        status, verb = VERBS[name]
        done = run(folder, verb, **poor)
        assert (done.returncode, b"UnicodeEncodeError" in done.stderr) == (status, False), (name, done.stderr)


@pytest.mark.parametrize("poor", POOR, ids=lambda poor: "-".join(poor.values()))
def test_the_tree_is_drawn_with_what_there_is(folder: Path, poor: dict[str, str]) -> None:
    done = run(folder, "new my_new --maintainer A --email a@b.example", **poor)
    assert (done.returncode, done.stderr) == (0, b"")
    assert b"|-- my_new/" in done.stdout
    assert b"`-- " in done.stdout
    assert done.stdout.isascii()


def test_the_tree_is_drawn_with_lines_where_they_can_be(folder: Path) -> None:
    assert "├── my_new/" in run(folder, "new my_new --dry-run", PYTHONIOENCODING="utf-8").stdout.decode()


def test_names_of_any_bytes_are_reported_everywhere(folder: Path) -> None:
    (folder / "my_pkg/launch").mkdir()
    odd = os.fsencode(folder / "my_pkg/launch") + b"/a\xff\x1b.launch.xml"
    with open(odd, "wb") as stream:  # noqa: PTH123
        stream.write(b"<launch><nod/></launch>")
    for form in ("text", "sarif", "junit"):  # all are written in test_output_safety.py
        done = run(folder, f"lint my_pkg --format {form} --output {form}:report")
        assert (done.returncode, done.stderr) == (1, b""), form
        assert done.stdout == (folder / "report").read_bytes()
        assert b"\xff" not in done.stdout
        assert b"\x1b" not in done.stdout
        assert b"udcff" in done.stdout or b"%FF%1B" in done.stdout
    assert run(folder, "lint my_pkg --write-baseline known.json").returncode == 0
    assert run(folder, "lint my_pkg --baseline known.json").returncode == 0
    for verb in ("inspect my_pkg", "inspect my_pkg --format json", "lint my_pkg --diff"):
        done = run(folder, verb)
        assert done.returncode in (0, 1)
        assert b"fault" not in done.stderr
        assert b"\x1b" not in done.stdout
    assert b"fault" not in run(folder, "lint my_pkg --add-ignores later").stderr


def test_what_is_typed_comes_back_harmless(folder: Path) -> None:
    for typed in ("$'lint a\\n::error::b'", "$'a\\x1b]0;x\\x07'", "lint $'--a\\n::error::\\x1b'", "lint $'\\xff'"):
        done = run(folder, typed.replace("$'lint a", "lint $'a"))
        assert done.returncode == 2
        assert b"\x1b" not in done.stderr
        assert b"\xff" not in done.stderr
        assert done.stderr.count(b"\n") == 1

"""`lint --watch`: again after each change of what lint looked at, and not otherwise."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
from collections.abc import Callable, Iterator
from contextlib import redirect_stderr, redirect_stdout
from io import StringIO
from pathlib import Path

import pytest

from rospkg_cli.cli import UsageError
from rospkg_cli.cli.lint import watch as watching
from rospkg_cli.cli.lint.lint_options import FixOptions, LintOptions, ReportOptions
from rospkg_cli.cli.lint.run import lint_to
from rospkg_cli.disk_trace import current_trace


@pytest.fixture
def package(tmp_path: Path, write, clean, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "cache"))
    return write(tmp_path / "ws/my_pkg", clean)


def watched(package: Path, *changes: Callable[[], object]) -> tuple[list[str], str]:
    """Return what is printed at the start and after each change, and what is said on stderr."""
    out, err, printed = StringIO(), StringIO(), list[str]()

    def ticks(folder: Path) -> Iterator[None]:
        assert folder == package
        yield
        for change in changes:
            printed.append(out.getvalue())
            out.seek(0)
            out.truncate()
            change()
            yield
        printed.append(out.getvalue())
        raise KeyboardInterrupt

    with redirect_stdout(out), redirect_stderr(err):
        assert (
            watching.watch(LintOptions(paths=(package,), report=ReportOptions(format="concise")), lint_to, ticks) == 0
        )
    assert current_trace() is None
    return printed, err.getvalue()


def test_each_change_is_linted_and_nothing_else(package: Path) -> None:
    manifest, config = package / "package.xml", package.parent / "rospkg.toml"
    text = manifest.read_text()
    printed, said = watched(
        package,
        lambda: None,
        lambda: manifest.write_text(text.replace("Apache-2.0", "TODO")),
        manifest.touch,
        lambda: (package / "__pycache__").mkdir(),
        lambda: config.write_text("select = 3\n"),
        lambda: config.write_text('select = ["SET"]\n'),
        config.unlink,
        lambda: manifest.write_text(text),
    )
    assert ["XML104" in each for each in printed] == [False, False, True, False, False, False, False, True, False]
    assert said.count("watching; Ctrl-C ends") == 6
    assert "rospkg.toml:1:1: `select`" in said


def test_what_writes_is_refused(package: Path) -> None:
    with pytest.raises(UsageError, match="changes nothing"):
        watching.watch(LintOptions(fixing=FixOptions(fix=True)), lint_to)


def test_a_terminal_is_cleared(package: Path) -> None:
    class Terminal(StringIO):
        def isatty(self) -> bool:
            return True

    with redirect_stdout(Terminal()) as out, redirect_stderr(StringIO()):
        watching.watch(LintOptions(paths=(package,)), lint_to, lambda _: iter([None]))
    assert out.getvalue().startswith(watching.CLEAR)


def test_without_watchfiles_it_looks_now_and_then(monkeypatch: pytest.MonkeyPatch) -> None:
    slept: list[float] = []
    times = iter([0.0, 0.0, 1.0, 2.0, 3.0])
    monkeypatch.setitem(sys.modules, "watchfiles", None)
    monkeypatch.setattr(watching.time, "sleep", slept.append)
    monkeypatch.setattr(watching.time, "process_time", lambda: next(times))
    moments = watching.moments(Path())
    for _ in range(4):
        next(moments)
    assert slept == [0.5, 0.5, 20.0]


def test_watchfiles_is_asked_where_it_is_installed(monkeypatch: pytest.MonkeyPatch) -> None:
    asked: list[object] = []

    class Fake:
        @staticmethod
        def watch(folder: Path, **options: object) -> Iterator[set[object]]:
            asked.append((folder, options["rust_timeout"], options["yield_on_timeout"]))
            yield {1}

    monkeypatch.setitem(sys.modules, "watchfiles", Fake)
    assert list(watching.moments(Path("x"))) == [None, None]
    assert asked == [(Path("x"), 5000, True)]


def test_ctrl_c_ends_it(package: Path) -> None:
    command = [sys.executable, "-m", "rospkg_cli", "lint", "--watch"]
    run = subprocess.Popen(command, cwd=package, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    assert run.stdout is not None
    try:
        first = run.stdout.readline()
        os.kill(run.pid, signal.SIGINT)
        out, err = run.communicate(timeout=60)
    finally:
        run.kill()
    assert (run.returncode, out) == (0, "")
    assert "No problems found" in first
    assert "Traceback" not in err

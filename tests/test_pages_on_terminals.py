"""A page of HTML goes to a file or into a pipe, and never onto a terminal."""

from __future__ import annotations

from io import StringIO
from pathlib import Path

import in_process
import pytest
from renaming import below, python_package
from writing import Write


class Terminal(StringIO):
    def isatty(self) -> bool:
        return True


@pytest.mark.parametrize(
    ("command", "typed"),
    [
        ("graph", "`rospkg graph --format html > graph.html`"),
        ("lint", "`rospkg lint --format html > lint.html`"),
    ],
)
def test_a_terminal_gets_what_to_type(
    tmp_path: Path, write: Write, monkeypatch: pytest.MonkeyPatch, command: str, typed: str
) -> None:
    write(tmp_path, below("my_pkg", python_package("my_pkg")))
    piped = in_process.run_here(command, "--format", "html", cwd=tmp_path)
    assert piped.stdout.startswith("<!doctype html>")
    monkeypatch.setattr(in_process, "StringIO", Terminal)
    shown = in_process.run_here(command, "--format", "html", cwd=tmp_path)
    assert (shown.returncode, shown.stdout, typed in shown.stderr) == (2, "", True), shown.stderr
    assert in_process.run_here(command, cwd=tmp_path).returncode == 0

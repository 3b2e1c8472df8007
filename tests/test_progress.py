"""What a long run says of itself on a terminal."""

from __future__ import annotations

import os
import pty
import subprocess
import sys
from pathlib import Path

import pytest

CODE = """
import sys, time
from rospkg_cli.cli import progress
progress.DELAY = {delay}
with progress.progress() as say:
    say("reading 3 packages")
    time.sleep(0.5)
    say("checking 3 packages")
    time.sleep(0.5)
print("rich.status" in sys.modules)
"""


def on_a_terminal(delay: float) -> tuple[str, str]:
    """Run with a terminal as stderr; return what was seen on it, and stdout."""
    ours, theirs = pty.openpty()
    code = [sys.executable, "-c", CODE.format(delay=delay)]
    environment = {**os.environ, "TERM": "xterm", "COLUMNS": "80"}
    done = subprocess.run(code, stderr=theirs, stdout=subprocess.PIPE, text=True, env=environment, check=True)
    os.close(theirs)
    os.set_blocking(ours, False)
    try:
        seen = os.read(ours, 100_000).decode()
    except (BlockingIOError, OSError):
        seen = ""
    os.close(ours)
    return seen, done.stdout.strip()


@pytest.mark.skipif(sys.platform == "win32", reason="there are no pseudo terminals")
def test_after_a_while_it_says_what_it_is_at() -> None:
    seen, loaded = on_a_terminal(0.0)
    assert "reading 3 packages" in seen
    assert "checking 3 packages" in seen
    assert loaded == "True"


def test_a_short_run_says_nothing_and_loads_nothing() -> None:
    assert on_a_terminal(60) == ("", "False")


def test_where_no_terminal_is_nothing_is_said(tmp_path: Path) -> None:
    done = subprocess.run([sys.executable, "-c", CODE.format(delay=0.0)], capture_output=True, text=True, check=True)
    assert (done.stderr, done.stdout.strip()) == ("", "False")

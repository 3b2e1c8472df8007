"""What people see, as goldens to look at: `tests/screens/<workspace>-<width>.txt`.

`pytest tests/test_screens.py --update-golden` writes them anew; read the diff before it is committed.
"""

from __future__ import annotations

import io
import os
import pty
import re
import subprocess
import sys
from pathlib import Path

import pytest
from sample_findings import beginner, forty

from rospkg_cli.report import Report, render

SCREENS = Path(__file__).parent / "screens"
WORKSPACES = {"beginner": beginner, "forty": forty}
ESCAPE = re.compile("\x1b\\[[0-9;]*m")


def compare(name: str, text: str, pytestconfig: pytest.Config) -> None:
    golden = SCREENS / f"{name}.txt"
    if pytestconfig.getoption("--update-golden"):
        golden.parent.mkdir(exist_ok=True)
        golden.write_text(text)
    assert text == golden.read_text()


def rendered(workspace: str, width: int | None, **how: bool) -> str:
    stream = io.StringIO()
    render("text", Report(WORKSPACES[workspace](), Path("/ws"), Path("/ws"), width=width, **how), stream)
    return stream.getvalue()


@pytest.mark.parametrize("width", [60, 80, 100, 160, None])
@pytest.mark.parametrize("workspace", WORKSPACES)
def test_a_screen(workspace: str, width: int | None, pytestconfig: pytest.Config) -> None:
    text = rendered(workspace, width)
    for line in text.splitlines() if width else ():
        assert len(line) <= width or " " not in line.strip(), line
    compare(f"{workspace}-{width or 'piped'}", text, pytestconfig)


@pytest.mark.parametrize("workspace", WORKSPACES)
def test_everything_at_80_columns_with_colours(workspace: str, pytestconfig: pytest.Config) -> None:
    text = rendered(workspace, 80, color=True, shows_info=True, shows_all=True)
    assert ESCAPE.sub("", text) == rendered(workspace, 80, shows_info=True, shows_all=True)
    if workspace == "beginner":
        compare("beginner-80-colours", text.replace("\x1b", "␛"), pytestconfig)


def test_the_first_report_on_forty_packages_fits_on_three_screens_and_ends_with_its_errors() -> None:
    for width, most in ((100, 150), (80, 260)):
        lines = rendered("forty", width).splitlines()
        assert len(lines) <= most
        errors = [number for number, line in enumerate(lines) if ": error " in line]
        assert errors
        assert errors[0] >= len(lines) - 49


def on_a_terminal(folder: Path, **environment: str) -> str:
    """Return what the command writes to a terminal of 72 columns."""
    reader, terminal = pty.openpty()
    command = [sys.executable, "-m", "rospkg_cli", "lint", "--no-cache"]
    variables = {**os.environ, "COLUMNS": "72", "TERM": "xterm", **environment}
    with subprocess.Popen(command, cwd=folder, stdout=terminal, stderr=subprocess.DEVNULL, env=variables):
        os.close(terminal)
        said = b""
        while True:
            try:
                more = os.read(reader, 65_536)
            except OSError:  # how Linux tells that nobody holds the terminal any more
                break
            said += more
            if not more:
                break
    os.close(reader)
    return said.decode().replace("\r\n", "\n")


def test_a_terminal_a_pipe_and_no_color(tmp_path: Path, write, clean) -> None:
    text = clean["package.xml"].replace("Drives my robot", "TODO: Package description")
    setup = (
        clean["setup.py"].rstrip().removesuffix(")")
        + "    entry_points={'console_scripts': ['a = my_pkg.b:main']},\n)\n"
    )
    folder = write(tmp_path / "my_pkg", {**clean, "package.xml": text, "setup.py": setup})
    coloured = on_a_terminal(folder)
    plain = on_a_terminal(folder, NO_COLOR="1")
    assert ESCAPE.search(coloured)
    assert ESCAPE.sub("", coloured) == plain
    assert 60 < max(map(len, plain.splitlines())) <= 72
    command = [sys.executable, "-m", "rospkg_cli", "lint", "--no-cache"]
    environment = {**os.environ, "COLUMNS": "72"}
    piped = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False, env=environment).stdout
    assert "\x1b" not in piped
    assert len(piped.splitlines()) < len(plain.splitlines())
    assert words(piped) == words(plain)


def words(text: str) -> list[str]:
    """Return the words of a report but for the lines of source, which are cut at the width of a terminal."""
    return " ".join(line for line in text.splitlines() if " | " not in line).split()

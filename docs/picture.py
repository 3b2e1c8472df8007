"""Draw docs/lint.svg, the README's picture: `python docs/picture.py` lints a small broken package, keeps the screen."""

from __future__ import annotations

import io
import os
import pty
import re
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from contextlib import suppress
from pathlib import Path
from typing import IO

from rich.console import Console
from rich.text import Text

from rospkg_cli.example import Example

COMMAND = "rospkg lint my_robot_nav"
WIDTH = 92
ENTRY = """\
    entry_points={
        'console_scripts': [
            'planner = my_pkg.path_planner:main',
            'recorder = my_pkg.recordr:main',
        ],
    },
)
"""
NODE = "import rclpy\nfrom nav_msgs.msg import Path\n\n\ndef main():\n    rclpy.init()\n"


def package() -> dict[str, str]:
    """Return a package with mistakes that cost people days."""
    files = Example(bad={}, good={}).bad_files()
    del files["setup.cfg"]
    return {
        **files,
        "setup.py": files["setup.py"].rstrip(")\n") + "\n" + ENTRY,
        "my_pkg/path_planner.py": NODE,
        "my_pkg/recorder.py": NODE.replace("nav_msgs.msg import Path", "rclpy.node import Node"),
        "package.xml": files["package.xml"].replace("  <export>", "  <exec_depend>rclpy</exec_depend>\n  <export>"),
    }


def screen(folder: Path) -> str:
    """Return what the command prints, with its colours."""
    for path, text in package().items():
        target = folder / "my_robot_nav" / path.replace("my_pkg", "my_robot_nav")
        target.parent.mkdir(parents=True, exist_ok=True)
        target.write_text(text.replace("my_pkg", "my_robot_nav"))
    command = [sys.executable, "-m", "rospkg_cli", *COMMAND.split()[1:], "--color", "always"]
    reader, terminal = pty.openpty()
    environment = {**os.environ, "COLUMNS": str(WIDTH)}
    with subprocess.Popen(command, cwd=folder, stdout=terminal, stderr=subprocess.DEVNULL, env=environment):
        os.close(terminal)
        with os.fdopen(reader, encoding="utf-8", newline="") as said:
            return "".join(until_closed(said)).replace("\r\n", "\n")


def until_closed(said: IO[str]) -> Iterator[str]:
    """Yield the lines of a terminal; Linux ends them with an error where nobody holds it any more."""
    with suppress(OSError):
        yield from said


def main() -> None:
    with tempfile.TemporaryDirectory() as scratch:
        said = screen(Path(scratch))
    console = Console(record=True, width=WIDTH, file=io.StringIO(), force_terminal=True)
    console.print(Text(f"$ {COMMAND}"), Text.from_ansi(said), sep="\n")
    svg = console.export_svg(title="rospkg")
    svg = svg.replace("<svg ", '<svg xml:space="preserve" ', 1)
    svg = re.sub(r"@font-face \{.*?\}\s*", "", svg, flags=re.DOTALL).replace("Fira Code", "DejaVu Sans Mono")
    Path(__file__).with_name("lint.svg").write_text(svg)


if __name__ == "__main__":
    main()

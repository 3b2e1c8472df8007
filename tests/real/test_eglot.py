"""`rospkg server` in Debian's Emacs, by eglot."""

from __future__ import annotations

import shutil
import sys
from pathlib import Path

from absent import absent
from shell import Shell

from rospkg_cli.example import Example

SCRIPT = Path(__file__).parent / "eglot.el"
SITE = Path("/usr/share/emacs/site-lisp/elpa")


def test_findings_come_and_go(tmp_path: Path, shell: Shell) -> None:
    if not shutil.which("emacs") or not [*SITE.glob("eglot-*")]:
        absent("needs emacs-nox and elpa-eglot")
    package = tmp_path / "ws/src/my_pkg"
    for path, text in Example(bad={}, good={}).bad_files().items():
        (package / path).parent.mkdir(parents=True, exist_ok=True)
        (package / path).write_text(text)
    variables = {
        "ROOT": str(tmp_path / "ws"),
        "FILE": str(package / "package.xml"),
        "ROSPKG": f"{Path(sys.executable).parent}/rospkg",
    }
    done = shell.run("emacs", "-q", "--batch", "-l", SCRIPT, cwd=tmp_path, **variables)
    told = [line.partition(" (")[0].removesuffix(" nil") for line in done.stdout.splitlines()]
    assert told == ["a finding comes: yes", "it goes: yes"], done.stdout + done.stderr

"""`rospkg server` in Debian's Neovim, by its own client."""

from __future__ import annotations

import shutil
import sys
from pathlib import Path

from absent import absent
from shell import Shell

from rospkg_cli.example import Example

SCRIPT = Path(__file__).parent / "neovim.lua"


def test_findings_come_and_go_and_an_action_is_applied(tmp_path: Path, shell: Shell) -> None:
    if not shutil.which("nvim"):
        absent("needs neovim")
    package = tmp_path / "ws/src/my_pkg"
    for path, text in Example(bad={}, good={}).bad_files().items():
        (package / path).parent.mkdir(parents=True, exist_ok=True)
        (package / path).write_text(text)
    manifest = package / "package.xml"
    variables = {"ROOT": str(tmp_path / "ws"), "FILE": str(manifest), "ROSPKG": f"{Path(sys.executable).parent}/rospkg"}
    done = shell.run("nvim", "--headless", "-u", "NONE", "-c", f"luafile {SCRIPT}", cwd=tmp_path, **variables)
    said, _, text = done.stdout.partition("<?xml")
    told = [line.partition(" [")[0] for line in said.splitlines()]
    assert told == [
        "a finding comes: yes", "it goes: yes", "a duplicate is told: yes", "its action removes it: yes",
    ], done.stdout + done.stderr  # fmt: skip
    assert text.count("<exec_depend>rclpy</exec_depend>") == 1
    assert "TODO" not in manifest.read_text()

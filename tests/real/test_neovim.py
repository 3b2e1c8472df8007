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
    for name in ("my_pkg", "my_other"):
        for path, text in Example(bad={}, good={}).bad_files().items():
            file = tmp_path / "ws/src" / name / path.replace("my_pkg", name)
            file.parent.mkdir(parents=True, exist_ok=True)
            file.write_text(text.replace("my_pkg", name))
    manifest = package / "package.xml"
    manifest.write_text(manifest.read_text().replace("  <export>", "  <depend>my_other</depend>\n  <export>"))
    variables = {"ROOT": str(tmp_path / "ws"), "FILE": str(manifest), "ROSPKG": f"{Path(sys.executable).parent}/rospkg"}
    done = shell.run("nvim", "--headless", "-u", "NONE", "-c", f"luafile {SCRIPT}", cwd=tmp_path, **variables)
    said, _, text = done.stdout.partition("<?xml")
    told = [line.partition(" [")[0] for line in said.splitlines()]
    assert told == [
        "a finding comes: yes", "it goes: yes", "a duplicate is told: yes", "its action removes it: yes",
        "a definition opens: yes",
    ], done.stdout + done.stderr  # fmt: skip
    assert text.count("<exec_depend>rclpy</exec_depend>") == 1
    assert "TODO" not in manifest.read_text()

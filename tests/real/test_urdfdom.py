"""Our verdict on plain URDF is that of the real urdfdom."""

from __future__ import annotations

import os
import shutil
import sys
from pathlib import Path

import pytest
from absent import absent
from shell import Shell
from urdf_texts import REFUSED, TAKEN

ROOT = Path(__file__).parents[2]


@pytest.mark.debian
def test_verdicts_agree_on_texts_and_on_damaged_ones(shell: Shell, tmp_path: Path) -> None:
    if not shutil.which("check_urdf"):
        absent("needs the Debian package liburdfdom-tools")
    for number, body in enumerate([*TAKEN, *REFUSED]):
        (tmp_path / f"{number}.urdf").write_text(f'<robot name="r">{body}</robot>', encoding="utf-8")
    command = (sys.executable, "-m", "bench.urdf", str(tmp_path), "--mutations", "150")
    said = shell.run(*command, cwd=ROOT, PYTHONPATH=os.pathsep.join(map(str, (ROOT / "src", ROOT))))
    assert said.returncode == 0, said.stdout + said.stderr
    assert "damaged: 150" in said.stdout

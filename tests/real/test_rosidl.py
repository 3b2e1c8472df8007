"""Our verdict on interface files is that of the real rosidl."""

from __future__ import annotations

import os
import sys
from pathlib import Path

import pytest
from conftest import DEBIAN_PYTHON
from interface_texts import REFUSED, TAKEN
from shell import Shell

ROOT = Path(__file__).parents[2]


@pytest.mark.debian
def test_verdicts_agree_on_texts_and_on_damaged_ones(shell: Shell, tmp_path: Path) -> None:
    for number, (kind, text) in enumerate([*TAKEN, *REFUSED]):
        (tmp_path / f"T{number}.{kind}").write_text(text, encoding="utf-8")
    command = (sys.executable, "-m", "bench.interfaces", str(tmp_path), "--python", DEBIAN_PYTHON, "--mutations", "400")
    said = shell.run(*command, cwd=ROOT, PYTHONPATH=os.pathsep.join(map(str, (ROOT / "src", ROOT))))
    assert said.returncode == 0, said.stdout + said.stderr
    assert "400 mutations" in said.stdout

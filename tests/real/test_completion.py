"""What real shells complete: bash always, fish and zsh where they are installed."""

from __future__ import annotations

import shutil
import sys
from pathlib import Path

import pytest
from absent import absent
from shell import Shell

SCRIPTS = {
    "bash": 'eval "$(rospkg --show-completion)"; COMP_WORDS=(rospkg lint --select URD00); COMP_CWORD=3\n'
    '_rospkg_completion rospkg; echo "${COMPREPLY[@]}"\n',
    "fish": 'rospkg --show-completion | source; complete -C "rospkg lint --select URD00"\n',
    "zsh": 'compdef() { }; eval "$(rospkg --show-completion)"; _arguments() { print -r -- "$@" | tr -d "\\":*()" }\n'
    "words=(rospkg lint --select URD00); CURRENT=4; _rospkg_completion\n",
}


@pytest.mark.parametrize("name", [*SCRIPTS])
def test_codes_are_completed(name: str, tmp_path: Path, shell: Shell) -> None:
    if not shutil.which(name):
        absent(f"needs {name}")
    (tmp_path / "script").write_text(SCRIPTS[name])
    done = shell.before(Path(sys.executable).parent).run(name, tmp_path / "script", cwd=tmp_path)
    assert done.stdout.split() == ["URD001", "URD002"], done.stderr

"""Running a command in an environment that is given, and no other."""

from __future__ import annotations

import os
import shutil
import subprocess
from dataclasses import dataclass
from pathlib import Path


@dataclass(frozen=True)
class Shell:
    """Runs commands with nothing of the outer environment but what reaches a package index."""

    variables: dict[str, str]

    def run(self, *command: str | Path, cwd: Path, **extra: str) -> subprocess.CompletedProcess[str]:
        """Run a command to its end; its status is the caller's to judge. `extra` are more variables."""
        line = [str(word) for word in command]
        env = {**self.variables, **extra}
        program = shutil.which(line[0], path=env["PATH"]) or line[0]
        return subprocess.run(
            [program, *line[1:]], cwd=cwd, env=env, capture_output=True, text=True, check=False, timeout=600
        )

    def before(self, folder: Path) -> Shell:
        """Return a shell that looks for programs in a folder first."""
        return Shell({**self.variables, "PATH": f"{folder}{os.pathsep}{self.variables['PATH']}"})

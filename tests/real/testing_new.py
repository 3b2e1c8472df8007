"""What the tests of written packages have in common: where they go, who judges them."""

from __future__ import annotations

import re
import sys
from collections.abc import Iterable
from pathlib import Path

from shell import Shell

sys.path.insert(0, str(Path(__file__).parents[1]))  # for `planned`

from planned import around as around
from planned import plan as plan

from rospkg_cli.scaffold.plan import Plan
from rospkg_cli.scaffold.write import write_folder

STANDINS = Path(__file__).parents[1] / "standins"
PREFIX = STANDINS / "prefix"
"""CMake configs of packages that neither Debian nor a package index has."""


def write(planned: Plan, workspace: Path) -> Path:
    """Write a package into the `src` of a workspace, and return its folder."""
    folder = workspace / "src" / planned.answers.name
    write_folder(folder, planned.files)
    return folder


def results(colcon: Shell, workspace: Path) -> dict[str, int]:
    """Return how many tests there were, and how many of them failed or were skipped."""
    said = colcon.run("colcon", "test-result", "--verbose", cwd=workspace)
    assert said.returncode == 0, said.stdout
    [summary] = [line for line in said.stdout.splitlines() if line.startswith("Summary:")]
    return {what: int(count) for count, what in re.findall(r"(\d+) (\w+)", summary)}


def linted(shell: Shell, folder: Path, linters: Iterable[str]) -> None:
    """Run Debian's ament linters over a package; each must be content.

    What mypy has found out about libraries is kept: that is nine tenths of what all linters do together.
    """
    for linter in linters:
        options = ("--cache-dir", shell.variables["MYPY_CACHE_DIR"]) if linter == "mypy" else ()
        said = shell.run("/usr/bin/python3", f"/usr/bin/ament_{linter}", *options, cwd=folder)
        assert said.returncode == 0, f"{linter}: {said.stdout}{said.stderr}"

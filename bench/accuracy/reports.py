"""What `rospkg lint` says of repositories on this disk."""

from __future__ import annotations

import json
import subprocess
import sys
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

Finding = dict[str, Any]


@dataclass(frozen=True)
class Report:
    """The findings of one repository: as `--format json` has them, with paths relative to the repository."""

    repository: Path
    packages: int
    findings: tuple[Finding, ...]

    def number(self, severity: str) -> int:
        return sum(finding["severity"] == severity for finding in self.findings)

    def failing(self) -> set[str]:
        """Return the packages that alone make `rospkg lint` exit with 1."""
        return {str(finding["package"]) for finding in self.findings if finding["severity"] != "info"}


def reports(repositories: list[Path], options: list[str]) -> Iterator[Report]:
    for repository in repositories:
        yield lint(repository.resolve(), options)


def lint(repository: Path, options: list[str], python: str = sys.executable) -> Report:
    """Return the report of one repository, which is its own workspace, by the rospkg_cli of some Python.

    Raises:
        RuntimeError: lint did not end with a report.
    """
    command = [python, "-m", "rospkg_cli", "lint", ".", "--format", "json", *options]
    run = subprocess.run(command, cwd=repository, capture_output=True, text=True, check=False)
    if run.returncode not in (0, 1):
        raise RuntimeError(f"{repository}: exit {run.returncode}: {run.stderr.strip()[-500:]}")
    report = json.loads(run.stdout)
    return Report(repository, report["summary"]["packages"], tuple(report["findings"]))

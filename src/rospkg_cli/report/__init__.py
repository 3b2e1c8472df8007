"""How results are shown: one file a format, each one function `render(report, stream)`, loaded by name."""

from __future__ import annotations

import importlib
import os
from dataclasses import dataclass
from pathlib import Path
from typing import IO

from ..engine.session import Results
from ..finding import Finding, Severity

FORMATS = ("text", "concise", "json", "sarif", "github", "gitlab", "junit", "rdjson", "markdown")


@dataclass(frozen=True)
class Report:
    """The results of a run and how they are to be shown."""

    results: Results
    root: Path
    """Paths of findings are relative to it."""
    cwd: Path
    """Paths are shown relative to it."""
    color: bool = False
    verbose: bool = False
    fixed: int = 0
    """How many findings `--fix` mended."""
    width: int = 80

    def path(self, path: str) -> str:
        """Return a finding's path as the user should see it, with `/`."""
        return Path(os.path.relpath(self.root / path, self.cwd)).as_posix()

    def count(self, severity: Severity) -> int:
        return sum(finding.severity is severity for finding in self.results.findings)

    def where(self, finding: Finding) -> str:
        """Return `path:line:column`."""
        return f"{self.path(finding.place.path)}:{finding.place.line}:{finding.place.column}"


def render(name: str, report: Report, stream: IO[str]) -> None:
    """Write a report in a format of FORMATS."""
    importlib.import_module(f".{name}", __name__).render(report, stream)

"""How results are shown: one file a format, each one function `render(report, stream)`, loaded by name."""

from __future__ import annotations

import importlib
import os
from pathlib import Path
from typing import IO

from ..control_characters import visible, without_workflow_commands
from ..engine.run.results import Results
from ..finding import Finding, Severity
from ..light_dataclasses import dataclass, replace
from .printable import printable

FORMATS = ("text", "concise", "json", "sarif", "github", "gitlab", "junit", "rdjson", "markdown", "html")
EXACT = frozenset({"json", "sarif", "gitlab", "rdjson"})
"""The formats whose own syntax can hold every character: they get the text as it is in the files, and write it with
`dump`. All others get text in which nothing is left that a terminal or a log would obey."""


@dataclass(frozen=True)
class Report:
    """The results of a run and how they are to be shown."""

    results: Results
    root: Path
    """Paths of findings are relative to it."""
    cwd: Path
    """Paths are shown relative to it."""
    color: bool = False
    fixed: int = 0
    """How many findings `--fix` fixed."""
    uncovered: int = 0
    """How many of them only came up while others were fixed."""
    width: int | None = None
    """Columns of the text for people; None where no line is broken."""
    exact: bool = False
    """Whether paths are given as they are, not as they can be shown."""
    shows_info: bool = False
    """Whether that text shows infos as it shows other findings; else they are only counted."""
    shows_all: bool = False
    """Whether it shows every finding in full, however many there are."""

    def path(self, path: str) -> str:
        """Return a finding's path as the user should see it, with `/`."""
        found = Path(os.path.relpath(self.root / path, self.cwd)).as_posix()
        return found if self.exact else without_workflow_commands(visible(found))

    def count(self, severity: Severity) -> int:
        return sum(finding.severity is severity for finding in self.results.findings)

    def where(self, finding: Finding) -> str:
        """Return `path:line:column`."""
        return f"{self.path(finding.location.path)}:{finding.location.line}:{finding.location.column}"


def render(name: str, report: Report, stream: IO[str]) -> None:
    """Write a report in a format of FORMATS."""
    if name in EXACT:
        report = replace(report, exact=True)
    else:
        findings = tuple(printable(finding) for finding in report.results.findings)
        report = replace(report, results=replace(report.results, findings=findings))
    importlib.import_module(f".{name}", __name__).render(report, stream)

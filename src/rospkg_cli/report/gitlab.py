"""GitLab's code quality report: one JSON list."""

from __future__ import annotations

from typing import IO

from ..finding import Severity
from . import Report
from .dump import dump
from .fingerprint import fingerprints

LEVELS = {Severity.ERROR: "critical", Severity.WARNING: "major", Severity.INFO: "info"}


def render(report: Report, stream: IO[str]) -> None:
    entries = [
        {
            "description": f"{finding.code}: {finding.message}",
            "check_name": finding.name,
            "fingerprint": mark,
            "severity": LEVELS[finding.severity],
            "location": {
                "path": report.path(finding.location.path),
                "positions": {
                    "begin": {"line": finding.location.line, "column": finding.location.column},
                    "end": {"line": finding.location.end_line, "column": finding.location.end_column},
                },
            },
        }
        for finding, mark in fingerprints(report, report.results.findings)
    ]
    dump(entries, stream)

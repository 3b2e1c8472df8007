"""reviewdog's diagnostic format, with suggestions for the edits of safe fixes."""

from __future__ import annotations

from typing import IO, Any

from ..finding import Edit, Finding, Location, Safety, Severity
from ..rule_address import web_address
from . import Report
from .dump import dump

LEVELS = {Severity.ERROR: "ERROR", Severity.WARNING: "WARNING", Severity.INFO: "INFO"}


def render(report: Report, stream: IO[str]) -> None:
    document = {
        "source": {"name": "rospkg"},
        "diagnostics": [diagnostic(report, finding) for finding in report.results.findings],
    }
    dump(document, stream)


def diagnostic(report: Report, finding: Finding) -> dict[str, Any]:
    found: dict[str, Any] = {
        "message": finding.message,
        "severity": LEVELS[finding.severity],
        "code": code(finding),
        "location": {"path": report.path(finding.location.path), "range": span(finding.location)},
    }
    suggestions = suggested(finding)
    return {**found, "suggestions": suggestions} if suggestions else found


def code(finding: Finding) -> dict[str, str]:
    page = web_address(finding.code)
    return {"value": finding.code, "url": page} if page else {"value": finding.code}


def suggested(finding: Finding) -> list[dict[str, Any]]:
    """Return the edits of a safe fix that changes nothing but this file."""
    fix = finding.fix
    if fix is None or fix.safety is Safety.UNSAFE:
        return []
    if any(not isinstance(o, Edit) or o.path != finding.location.path for o in fix.operations):
        return []
    edits = [o for o in fix.operations if isinstance(o, Edit)]
    return [{"range": span(at), "text": edit.text} for edit, at in zip(edits, finding.edit_locations, strict=True)]


def span(at: Location) -> dict[str, Any]:
    return {
        "start": {"line": at.line, "column": at.column},
        "end": {"line": at.end_line, "column": at.end_column},
    }

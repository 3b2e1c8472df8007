"""JSON, as `schemas/report.schema.json` describes it. Columns count code points from 1."""

from __future__ import annotations

from typing import IO, Any

from .. import __version__
from ..finding import Chmod, Create, Delete, Edit, Finding, Location, Move, Severity
from . import Report
from .dump import dump

SCHEMA = 1


def render(report: Report, stream: IO[str]) -> None:
    dump(document(report), stream)


def document(report: Report) -> dict[str, Any]:
    results = report.results
    return {
        "schema": SCHEMA,
        "tool": {"name": "rospkg", "version": __version__},
        "findings": [entry(report, finding) for finding in results.findings],
        "suppressed": [{**entry(report, f), "reason": f.suppressed} for f in results.suppressed],
        "summary": {
            "packages": results.packages,
            "files": results.files,
            **{f"{level.value}s": report.count(level) for level in reversed(Severity)},
            "suppressed": len(results.suppressed),
            "fixed": report.fixed,
        },
    }


def entry(report: Report, finding: Finding) -> dict[str, Any]:
    return {
        "code": finding.code,
        "name": finding.name,
        "severity": finding.severity.value,
        "message": finding.message,
        **place(report, finding.location),
        "package": finding.package,
        "related": [{"message": message, **place(report, at)} for at, message in finding.related],
        "fix": fix(report, finding),
    }


def place(report: Report, at: Location) -> dict[str, Any]:
    return {
        "path": report.path(at.path),
        "line": at.line,
        "column": at.column,
        "end_line": at.end_line,
        "end_column": at.end_column,
    }


def fix(report: Report, finding: Finding) -> dict[str, Any] | None:
    if finding.fix is None:
        return None
    operations = finding.fix.operations
    edits = [o for o in operations if isinstance(o, Edit)]
    return {
        "title": finding.fix.title,
        "safety": finding.fix.safety.value,
        "edits": [
            {**place(report, at), "text": edit.text} for edit, at in zip(edits, finding.edit_locations, strict=True)
        ],
        "creates": [
            {"path": report.path(o.path), "text": o.text, "executable": o.executable}
            for o in operations
            if isinstance(o, Create)
        ],
        "deletes": [{"path": report.path(o.path)} for o in operations if isinstance(o, Delete)],
        "moves": [{"path": report.path(o.path), "to": report.path(o.to)} for o in operations if isinstance(o, Move)],
        "modes": [
            {"path": report.path(o.path), "executable": o.executable} for o in operations if isinstance(o, Chmod)
        ],
    }

"""A sheet of findings to judge: all errors, and warnings drawn by chance, in an order that says nothing."""

from __future__ import annotations

import json
import random
from pathlib import Path
from typing import Any

from bench.accuracy.reports import Finding, Report


def sheet(found: list[Report], warnings: int, seed: int) -> list[str]:
    """Return one line of JSON for each finding drawn: id, repository, code, level, place, message, related places."""
    draw = random.Random(seed)
    errors = [line(report, finding) for report in found for finding in report.findings if is_level(finding, "error")]
    others = [line(report, finding) for report in found for finding in report.findings if is_level(finding, "warning")]
    drawn = errors + draw.sample(others, min(warnings, len(others)))
    draw.shuffle(drawn)
    return [json.dumps({"id": number, **row}, ensure_ascii=False) for number, row in enumerate(drawn, 1)]


def is_level(finding: Finding, severity: str) -> bool:
    return bool(finding["severity"] == severity)


def line(report: Report, finding: Finding) -> dict[str, Any]:
    fix = finding["fix"]
    return {
        "repository": str(report.repository),
        "code": finding["code"],
        "level": finding["severity"],
        "place": f"{finding['path']}:{finding['line']}",
        "message": finding["message"],
        "related": [f"{place['path']}:{place['line']} {place['message']}" for place in finding["related"]],
        "fix": f"{fix['safety']}: {fix['title']}" if fix else None,
    }


def read_lines(path: Path) -> list[dict[str, Any]]:
    return [json.loads(text) for text in path.read_text(encoding="utf-8").splitlines() if text.strip()]

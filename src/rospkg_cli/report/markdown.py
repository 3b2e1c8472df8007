"""Markdown for the summary of a workflow run: a table of findings, at most 200 of them."""

from __future__ import annotations

from typing import IO

from ..finding import Finding
from . import Report
from .text import summary

MOST = 200


def render(report: Report, stream: IO[str]) -> None:
    findings = report.results.findings
    stream.write(f"## rospkg lint\n\n{summary(report)}\n")
    if findings:
        stream.write("\n| | Rule | Where | What |\n|---|---|---|---|\n")
        stream.writelines(row(report, finding) for finding in findings[:MOST])
    if len(findings) > MOST:
        stream.write(f"\n… and {len(findings) - MOST} more.\n")


def row(report: Report, finding: Finding) -> str:
    cells = (finding.severity.value, f"{finding.code} {finding.name}", f"`{report.where(finding)}`", finding.message)
    return "| " + " | ".join(" ".join(cell.split()).replace("|", "\\|") for cell in cells) + " |\n"

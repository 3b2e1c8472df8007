"""One line a finding: `path:line:column: severity CODE name: message`, as editors' problem matchers read it."""

from __future__ import annotations

from typing import IO

from . import Report


def render(report: Report, stream: IO[str]) -> None:
    for finding in report.results.findings:
        message = " ".join(finding.message.split())
        where = report.where(finding)
        stream.write(f"{where}: {finding.severity.value} {finding.code} {finding.name}: {message}\n")

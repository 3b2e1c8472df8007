"""Annotations of GitHub's workflow runs: one command a line."""

from __future__ import annotations

from typing import IO

from ..finding import Severity
from . import Report

LEVELS = {Severity.ERROR: "error", Severity.WARNING: "warning", Severity.INFO: "notice"}


def render(report: Report, stream: IO[str]) -> None:
    for finding in report.results.findings:
        place = finding.location
        properties = {
            "file": report.path(place.path),
            "line": place.line,
            "endLine": place.end_line,
            "col": place.column,
            "endColumn": place.end_column,
            "title": f"{finding.code} {finding.name}",
        }
        if place.end_line != place.line:
            del properties["col"], properties["endColumn"]  # GitHub refuses columns over several lines
        listed = ",".join(f"{key}={escape(str(value), ',:')}" for key, value in properties.items())
        stream.write(f"::{LEVELS[finding.severity]} {listed}::{escape(finding.message)}\n")


def escape(text: str, also: str = "") -> str:
    """Escape as the workflow commands want it: per cent, line ends, and in properties `:` and `,`."""
    for char in "%\r\n" + also:
        text = text.replace(char, f"%{ord(char):02X}")
    return text

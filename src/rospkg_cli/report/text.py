"""For people: the line of source with the spot underlined, what is wrong, and how to fix it."""

from __future__ import annotations

import textwrap
from typing import IO

from ..control_characters import visible_lines, without_workflow_commands
from ..engine.baseline import REASON
from ..finding import Finding, Safety, Severity
from .color import SEVERITY_COLORS, paint

from . import Report  # isort: skip

MAX_EXCERPT = 110


def render(report: Report, stream: IO[str]) -> None:
    for finding in report.results.findings:
        stream.write("\n".join(block(report, finding)) + "\n\n")
    stream.write(summary(report) + "\n")


def block(report: Report, finding: Finding) -> list[str]:
    """Return the lines that show one finding."""
    color, level = report.color, SEVERITY_COLORS[finding.severity]
    head = f"{paint(report.where(finding), 'bold', color)}: {paint(finding.severity.value, level, color)} "
    lines = [head + f"{finding.code} {paint(finding.name, 'dim', color)}", *excerpt(report, finding)]
    lines += wrapped(finding.message, report.width)
    for place, why in finding.related:
        lines += wrapped(f"see {report.path(place.path)}:{place.line}:{place.column}: {why}", report.width)
    if finding.fix:
        how = "--fix" if finding.fix.safety is Safety.SAFE else "--fix --unsafe-fixes"
        title = finding.fix.title[0].lower() + finding.fix.title[1:]
        lines += [paint(line, "green", color) for line in wrapped(f"{how}: {title}", report.width)]
    return lines


def wrapped(text: str, width: int) -> list[str]:
    lines = textwrap.wrap(
        text, width, initial_indent="  ", subsequent_indent="  ", break_long_words=False, break_on_hyphens=False
    )
    return [without_workflow_commands(line) for line in lines]


def excerpt(report: Report, finding: Finding) -> list[str]:
    """Return the source line with a number, and a line of carets below it; nothing for a file without text."""
    line = finding.excerpt.removesuffix("\r")
    if not line.strip():
        return []
    place, tabs = finding.location, drawn(line)
    start = len(drawn(line[: place.column - 1]))
    end = place.end_column - 1 if place.end_line == place.line else len(line.rstrip())
    length = max(1, len(drawn(line[:end])) - start)
    skipped = max(0, min(start - 20, len(tabs) - MAX_EXCERPT)) if len(tabs) > MAX_EXCERPT else 0
    shown = tabs[skipped : skipped + MAX_EXCERPT].rstrip()
    start -= skipped
    marks = "^" * max(1, min(length, len(shown) - start))
    gutter = f"{place.line:>5} | "
    return [
        paint(gutter, "dim", report.color) + shown,
        paint(" " * 5 + " | ", "dim", report.color)
        + " " * start
        + paint(marks, SEVERITY_COLORS[finding.severity], report.color),
    ]


def drawn(line: str) -> str:
    """Return a line of source as it is shown: what a terminal would obey is seen, tabs are blanks."""
    return visible_lines(line).expandtabs(4)


def summary(report: Report) -> str:
    """Return the last line: how many findings there are, how many can be fixed, how many are set aside."""
    results, color = report.results, report.color
    where = f"{counted(results.packages, 'package')}, {counted(results.files, 'file')}"
    counts = [counted(n, level.value) for level in reversed(Severity) if (n := report.count(level))]
    parts = (
        [f"Found {', '.join(counts)} in {where}."]
        if counts
        else [f"{paint('No problems found', 'green', color)} ({where})."]
    )
    safe = sum(f.fix is not None and f.fix.safety is Safety.SAFE for f in results.findings)
    unsafe = sum(f.fix is not None and f.fix.safety is Safety.UNSAFE for f in results.findings)
    if report.fixed:
        parts.append(f"{report.fixed} fixed.")
    if safe:
        parts.append(f"{safe} fixable with --fix.")
    if unsafe:
        parts.append(f"{unsafe}{' more' if safe else ''} fixable with --fix --unsafe-fixes.")
    known = sum(finding.suppressed == REASON for finding in results.suppressed)
    if known:
        parts.append(f"{known} in the baseline.")
    if len(results.suppressed) > known:
        parts.append(f"{len(results.suppressed) - known} ignored.")
    return " ".join(parts)


def counted(number: int, what: str) -> str:
    plural = {"info": "info"}.get(what, f"{what}s")
    return f"{number} {what if number == 1 else plural}"

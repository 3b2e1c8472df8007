"""The sentence at the end of a report: how many findings there are, can be fixed, are set aside."""

from __future__ import annotations

from collections import Counter

from ..engine.baseline import REASON
from ..finding import Severity
from .color import paint

from . import Report  # isort: skip


def summary(report: Report) -> str:
    """Return the counts of a report in one line."""
    results, color = report.results, report.color
    where = f"{counted(results.packages, 'package')}, {counted(results.files, 'file')}"
    counts = [counted(n, level.value) for level in reversed(Severity) if (n := report.count(level))]
    later = f" ({report.uncovered} of them came up while others were fixed)" if report.uncovered else ""
    if report.fixed:
        parts = [f"{report.fixed} fixed{later}; {', '.join(counts) or 'nothing'} left in {where}."]
    elif counts:
        parts = [f"Found {', '.join(counts)} in {where}."]
    else:
        parts = [f"{paint('No problems found', 'green', color)} ({where})."]
    offered = Counter(finding.fix_options for finding in results.findings)
    safe, unsafe, infos = (offered[each] for each in ("--fix", "--fix --unsafe-fixes", "--fix --fix-level info"))
    if safe:
        parts.append(f"{safe} fixable with --fix.")
    if unsafe:
        parts.append(f"{unsafe}{' more' if safe else ''} fixable with --fix --unsafe-fixes.")
    if infos:
        parts.append(f"{infos} info fixable with --fix --fix-level info.")
    known = sum(finding.suppressed == REASON for finding in results.suppressed)
    if known:
        parts.append(f"{known} in the baseline.")
    if len(results.suppressed) > known:
        parts.append(f"{len(results.suppressed) - known} ignored.")
    return " ".join(parts)


def counted(number: int, what: str) -> str:
    """Return a number with a noun: `1 file`, `2 files`, `2 info`."""
    plural = {"info": "info"}.get(what, f"{what}s")
    return f"{number} {what if number == 1 else plural}"
